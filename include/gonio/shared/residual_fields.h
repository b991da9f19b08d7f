// SPDX-License-Identifier: Apache-2.0
// Where the numbers of a residual grid lie among a material's parameters. Read by C++ and OpenCL C.
#ifndef GONIO_SHARED_RESIDUAL_FIELDS
#define GONIO_SHARED_RESIDUAL_FIELDS

enum {
    residual_size,                               // of all of it, these fields included
    residual_plane,                              // values of one channel; 0 if there is no grid
    residual_channels,                           // of the grid
    residual_root,                               // 1: coordinate 0 is the square root of theta_h
    residual_count,                              // three: samples on theta_h, theta_d, phi_d
    residual_first = residual_count + 3,         // three: sample 1 of theta_h, theta_d, 0 of phi_d
    residual_inverse_step = residual_first + 3,  // three: samples a radian
    residual_last = residual_inverse_step + 3,   // two: the last sample of theta_h and theta_d
    residual_rest = residual_last + 2,           // two: from its angle to 90 degrees, in radians
    residual_values = residual_rest + 2
};

#endif
