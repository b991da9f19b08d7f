// SPDX-License-Identifier: Apache-2.0
// Where the light of the scalar Monte Carlo ends, in bins as MCML's.
#include "reference/scalar_tallies.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonio::reference {

ScalarTallies::ScalarTallies(const MonteCarloRequest& request, std::size_t layers)
    : request_(request), layers_(layers)
{
}

std::size_t ScalarTallies::r_bin(const ScalarPhoton& photon) const
{
    const double bin = photon.radius() / request_.dr;
    return bin < double(request_.r_bins) ? static_cast<std::size_t>(bin) : request_.r_bins;
}

std::size_t ScalarTallies::alpha_bin(double cosine) const
{
    const double bin = std::acos(cosine) / (std::numbers::pi / 2) * double(request_.alpha_bins);
    return std::min(static_cast<std::size_t>(bin), request_.alpha_bins - 1);
}

void ScalarTallies::leaves(const ScalarPhoton& photon)
{
    const bool down = photon.goes_down();
    const double weight = photon.weight;
    if (!down && !photon.met_matter) return specular(weight);
    if (down && !photon.scattered) return scores_.add(unscattered_transmittance_, weight);
    scores_.add(down ? diffuse_transmittance_ : diffuse_reflectance_, weight);
    if (!photon.scattered) return;
    scores_.add((down ? transmitted_r_ : reflected_r_) + r_bin(photon), weight);
    scores_.add((down ? transmitted_alpha_ : reflected_alpha_) + alpha_bin(std::abs(photon.uz)),
                weight);
}

void ScalarTallies::absorbed(const ScalarPhoton& photon, double weight)
{
    const double bin = photon.z / request_.dz;
    const std::size_t z =
        bin < double(request_.z_bins) ? static_cast<std::size_t>(bin) : request_.z_bins;
    scores_.add(absorption_ + photon.layer, weight);
    scores_.add(absorbed_z_ + z, weight);
    scores_.add(absorbed_zr_ + z * (request_.r_bins + 1) + r_bin(photon), weight);
}

MonteCarloResult ScalarTallies::result(std::size_t batch) const
{
    const auto one = [&](std::size_t place) { return scores_.estimate(place, batch); };
    const auto many = [&](std::size_t first, std::size_t count) {
        return scores_.estimates(first, count, batch);
    };
    const std::size_t r_bins = request_.r_bins + 1, z_bins = request_.z_bins + 1;
    return {.specular = one(specular_),
            .diffuse_reflectance = one(diffuse_reflectance_),
            .unscattered_transmittance = one(unscattered_transmittance_),
            .diffuse_transmittance = one(diffuse_transmittance_),
            .absorption = many(absorption_, layers_),
            .bottom_absorption = one(bottom_absorption_),
            .unfinished = one(unfinished_),
            .roulette = one(roulette_),
            .reflected_r = many(reflected_r_, r_bins),
            .reflected_alpha = many(reflected_alpha_, request_.alpha_bins),
            .transmitted_r = many(transmitted_r_, r_bins),
            .transmitted_alpha = many(transmitted_alpha_, request_.alpha_bins),
            .absorbed_z = many(absorbed_z_, z_bins),
            .absorbed_zr = many(absorbed_zr_, z_bins * r_bins)};
}

}  // namespace gonio::reference
