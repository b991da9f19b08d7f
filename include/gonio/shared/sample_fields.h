// SPDX-License-Identifier: Apache-2.0
// What the kernels of sampling exchange with the host, read by C++ and by OpenCL C: the order of
// the planes, each with one number per sample.
#ifndef GONIO_SAMPLE_FIELDS
#define GONIO_SAMPLE_FIELDS

/// A viewer v - r, r the mirror direction of the light.
enum offset_field { offset_x, offset_y, offset_z, offset_fields };

/// A sample: v, its density in 1/sr, and behind them f cos theta_o/pdf for each channel.
enum sample_field { sample_x, sample_y, sample_z, sample_pdf, sample_weights };

#endif
