// SPDX-License-Identifier: Apache-2.0
// An analytic lobe and a grid, after Ilyin, Lebedev, Sinyavsky & Ignatenko, GraphiCon 2009; a
// reconstruction. The lobe: Trowbridge & Reitz, JOSA 65, 1975, with Smith's masking in the form of
// Heitz, JCGT 3(2), 2014, eq. 99.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/cosine.hpp"
#include "reference/params.hpp"

namespace gonio::reference {
namespace {

double lobe(double alpha, glm::dvec3 l, glm::dvec3 v)
{
    const auto lambda = [alpha](glm::dvec3 w) {
        return 0.5 * (std::sqrt(1 + alpha * alpha * tangent2(w)) - 1);
    };
    const glm::dvec3 h = half_vector(l, v).h;
    const double q = (h.x * h.x + h.y * h.y) / alpha + alpha * h.z * h.z;
    const double d = 1 / (std::numbers::pi * q * q);
    return d / (1 + lambda(l) + lambda(v)) / (4 * l.z * v.z);
}

/// Where a coordinate lies: between samples k and k + 1, the share of the latter.
struct Between {
    std::size_t k;
    double share;
};

/// positions of the samples ascend; held at the ends
Between between(double x, const std::vector<double>& positions)
{
    const auto above = std::upper_bound(positions.begin() + 1, positions.end() - 1, x);
    const auto k = static_cast<std::size_t>(above - positions.begin()) - 1;
    const double share = (x - positions[k]) / (positions[k + 1] - positions[k]);
    return {k, std::clamp(share, 0.0, 1.0)};
}

double folded_azimuth(glm::dvec3 l, glm::dvec3 v)
{
    const glm::dvec3 h = l + v;
    const double across = std::hypot(h.x, h.y);
    if (across == 0) return 0;
    // The azimuth of l about h: from the plane of n and h.
    const glm::dvec3 out(-h.y / across, h.x / across, 0);
    const glm::dvec3 in = glm::cross(out, h / glm::length(h));
    return std::atan2(std::abs(glm::dot(l - v, out)), std::abs(glm::dot(l - v, in)));
}

/// Trilinear interpolation in Rusinkiewicz's angles (EGWR 1998).
double residual(const ResidualGrid& grid, glm::dvec3 l, glm::dvec3 v, std::size_t channel)
{
    const glm::dvec3 h = l + v;
    const double theta_h = std::atan2(std::hypot(h.x, h.y), h.z);
    const double theta_d = std::atan2(glm::length(l - v), glm::length(h));
    const auto& [thetas_h, thetas_d, azimuths] = grid.positions;
    const Between at_h = between(grid.root ? std::sqrt(theta_h) : theta_h, thetas_h);
    const Between at_d = between(theta_d, thetas_d);
    const Between at_phi = between(folded_azimuth(l, v), azimuths);
    const float* values = &grid.values[std::min(channel, grid.channels - 1) * grid.plane()];
    double sum = 0;
    for (std::size_t corner = 0; corner < 8; ++corner) {
        const auto side = [corner](std::size_t bit) { return corner >> bit & 1; };
        const auto weight = [](const Between& b, std::size_t up) {
            return up != 0 ? b.share : 1 - b.share;
        };
        const std::size_t row = (at_h.k + side(2)) * thetas_d.size() + (at_d.k + side(1));
        sum += weight(at_h, side(2)) * weight(at_d, side(1)) * weight(at_phi, side(0)) *
               static_cast<double>(values[row * azimuths.size() + at_phi.k + side(0)]);
    }
    return sum;
}

}  // namespace

/// (k_d/pi + k_s D G/(4 (n.l)(n.v))) exp R
double lebedev(const lebedev_params& p, glm::dvec3 l, glm::dvec3 v, std::size_t channel)
{
    const double analytic =
        p.k_d[channel] / std::numbers::pi + p.k_s[channel] * lobe(p.alpha, l, v);
    return p.residual ? analytic * std::exp(residual(*p.residual, l, v, channel)) : analytic;
}

}  // namespace gonio::reference
