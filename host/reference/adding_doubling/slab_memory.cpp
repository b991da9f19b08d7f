// SPDX-License-Identifier: Apache-2.0
// Finds a slab again by all that it depends on.
#include "reference/adding_doubling/slab_memory.hpp"

#include <algorithm>

namespace gonio::reference {
namespace {

constexpr std::size_t most = 256;  // slabs of some 20 KiB

/// Phase functions with more than a number are taken to differ.
bool same_phase(const PhaseFunction& a, const PhaseFunction& b)
{
    if (a.index() != b.index()) return false;
    if (const auto* phase = std::get_if<HenyeyGreenstein>(&a))
        return phase->g == std::get<HenyeyGreenstein>(b).g;
    return std::holds_alternative<Isotropic>(a) || std::holds_alternative<Rayleigh>(a);
}

bool same_layer(const Layer& a, const Layer& b)
{
    return a.mua == b.mua && a.mus == b.mus && a.n == b.n && a.d == b.d &&
           same_phase(a.phase, b.phase);
}

bool same_directions(const LocalDirections& a, const LocalDirections& b)
{
    return a.n == b.n && a.quadrature == b.quadrature && a.ids == b.ids &&
           (a.cosine == b.cosine).all() && a.root_weight == b.root_weight;
}

}  // namespace

Slab SlabMemory::operator()(const Layer& layer, const LocalDirections& directions, int mode)
{
    const auto known = std::ranges::find_if(solved_, [&](const Solved& solved) {
        return solved.mode == mode && same_layer(solved.layer, layer) &&
               same_directions(solved.directions, directions);
    });
    if (known != solved_.end()) return known->slab;
    if (solved_.size() == most) solved_.pop_back();
    solved_.push_front({layer, directions, mode, solve_slab(layer, directions, mode)});
    return solved_.front().slab;
}

}  // namespace gonio::reference
