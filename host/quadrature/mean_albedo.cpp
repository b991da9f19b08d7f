// SPDX-License-Identifier: Apache-2.0
// Mean albedos: a Gauss rule over directional ones.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "quadrature/derived.hpp"
#include "quadrature/rules.hpp"
#include "stopwatch.hpp"

namespace gonio {
namespace {

constexpr std::array orders{12, 16, 24, 32, 48};

/// Directions of one rule, and their weights. mu = u^2: nodes crowd at grazing light, where narrow
/// lobes change. Azimuths are the middles of even steps over a half circle, the period of every
/// model.
struct Directions {
    std::vector<Incidence> at;
    std::vector<double> weights;

    Directions(int order, bool isotropic)
    {
        const reference::QuadratureRule& rule = rule_of(order);
        const int azimuths = isotropic ? 1 : order / 2;
        for (Eigen::Index k = 0; k < rule.nodes.size(); ++k) {
            const double u = rule.nodes[k], mu = u * u;
            for (int a = 0; a < azimuths; ++a) {
                at.push_back({mu, isotropic ? 0 : 180 * (a + 0.5) / azimuths});
                weights.push_back(rule.weights[k] * 4 * u * mu / azimuths);
            }
        }
    }
};

Albedos mean_of_order(const Device& device, const std::vector<Material>& materials, int order,
                      const AlbedoOptions& options)
{
    const Directions directions(order, std::ranges::all_of(materials, &Material::isotropic));
    std::vector<AlbedoCell> cells;
    for (std::size_t m = 0; m < materials.size(); ++m)
        for (const Incidence& at : directions.at) cells.push_back({m, at});
    Albedos all = integrate_albedos(device, materials, cells, options);
    const auto mean = [&](std::vector<double>& plane) {
        std::vector<double> means(materials.size());
        for (std::size_t k = 0; k < plane.size(); ++k)
            means[cells[k].material] += plane[k] * directions.weights[k % directions.at.size()];
        plane = std::move(means);
    };
    std::ranges::for_each(all.value, mean);
    std::ranges::for_each(all.error, mean);
    return all;
}

}  // namespace

Albedos mean_albedos(const Device& device, const std::vector<Material>& materials, double max_error,
                     double seconds)
{
    const Stopwatch since;
    // What is left of the time is shared by this order and those behind it, as they have nodes.
    const auto of_order = [&](std::size_t k) {
        const double share = orders[k] / std::accumulate(orders.begin() + k, orders.end(), 0.0);
        return mean_of_order(device, materials, orders[k],
                             {Fixed::light, max_error / 2, share * (seconds - since.seconds())});
    };
    Albedos lower = of_order(0);
    for (std::size_t k = 1; k < orders.size(); ++k) {
        const double before = since.seconds();
        Albedos higher = of_order(k);
        higher.evaluated += lower.evaluated;
        higher.kernel_seconds += lower.kernel_seconds;
        bool reached = true;
        for (std::size_t c = 0; c < higher.value.size(); ++c)
            for (std::size_t m = 0; m < materials.size(); ++m) {
                const double value = higher.value[c][m];
                higher.error[c][m] += std::abs(value - lower.value[c][m]);
                reached = reached && higher.error[c][m] <= max_error * std::max(1.0, value);
            }
        lower = std::move(higher);
        const double now = since.seconds();
        if (reached || now + (now - before) > seconds) break;
    }
    return lower;
}

}  // namespace gonio
