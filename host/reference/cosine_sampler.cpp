// SPDX-License-Identifier: Apache-2.0
// Inverse distributions of the phase functions.
#include "reference/cosine_sampler.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace gonio::reference {
namespace {

/// Wang, Jacques and Zheng 1995, eq. 3.22, multiplied out so that nothing cancels for small g.
double sample_henyey_greenstein(double g, double u)
{
    const double s = 2 * u - 1, bias = 1 + g * s;
    return (s * (1 + g * g) + g / 2 * (3 + s * s - g * g * (1 - s * s))) / (bias * bias);
}

struct Sample {
    double u;
    const std::vector<double>& cumulative;

    double operator()(const HenyeyGreenstein& phase) const
    {
        return sample_henyey_greenstein(phase.g, u);
    }
    double operator()(const Isotropic&) const { return 2 * u - 1; }
    /// The distribution is (c^3 + 3 c + 4) / 8; c = 2 sinh x makes a triple angle of it.
    double operator()(const Rayleigh&) const { return 2 * std::sinh(std::asinh(4 * u - 2) / 3); }
    double operator()(const TwoTermHenyeyGreenstein& phase) const
    {
        const double w = phase.weight_1;
        return u < w ? sample_henyey_greenstein(phase.g_1, u / w)
                     : sample_henyey_greenstein(phase.g_2, (u - w) / (1 - w));
    }
    /// Between two points the density is linear and the distribution a parabola.
    double operator()(const TabulatedPhase& table) const
    {
        const double target = u * cumulative.back();
        const auto above = std::upper_bound(cumulative.begin() + 1, cumulative.end() - 1, target);
        const auto i = static_cast<std::size_t>(above - cumulative.begin()) - 1;
        const double width = table.cosine[i + 1] - table.cosine[i];
        const double area = (target - cumulative[i]) / width;
        const double start = table.value[i], rise = table.value[i + 1] - start;
        const double root = start + std::sqrt(std::max(start * start + 2 * rise * area, 0.0));
        return table.cosine[i] + (root > 0 ? width * 2 * area / root : 0);
    }
};

}  // namespace

CosineSampler::CosineSampler(const PhaseFunction& phase) : phase_(phase)
{
    const auto* table = std::get_if<TabulatedPhase>(&phase_);
    if (!table) return;
    cumulative_.push_back(0);
    for (std::size_t i = 1; i < table->cosine.size(); ++i) {
        cumulative_.push_back(cumulative_.back() + (table->value[i] + table->value[i - 1]) / 2 *
                                                       (table->cosine[i] - table->cosine[i - 1]));
    }
}

double CosineSampler::operator()(double u) const
{
    return std::clamp(std::visit(Sample{u, cumulative_}, phase_), -1.0, 1.0);  // rounding
}

}  // namespace gonio::reference
