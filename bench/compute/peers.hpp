// SPDX-License-Identifier: Apache-2.0
// What a good C++ programmer would write instead: float, -O3 -march=native -ffast-math, OpenMP on
// all cores.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace gonio::bench {

/// An isotropic grid's angles in radians; out: theta_i.size() * theta_o.size() * phi.size() floats.
struct PeerGrid {
    std::vector<float> theta_i, theta_o, phi;
};

/// Fills `out`; the model's parameters are its defaults.
using Peer = void (*)(const PeerGrid& grid, float* out);

struct Peers {
    std::string model;
    Peer tables;    ///< the kernels' formula with axis tables
    Peer textbook;  ///< vectors and angles, as a paper or a shader writes it
};

const std::vector<Peers>& peers();

}  // namespace gonio::bench
