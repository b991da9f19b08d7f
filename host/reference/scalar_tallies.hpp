// SPDX-License-Identifier: Apache-2.0
// Where the light of the scalar Monte Carlo ends.
#pragma once

#include "reference/scalar_monte_carlo.hpp"
#include "reference/scalar_photon.hpp"

namespace gonio::reference {

class ScalarTallies {
public:
    ScalarTallies(const MonteCarloRequest& request, std::size_t layers);

    void specular(double weight) { scores_.add(specular_, weight); }
    void bottom(double weight) { scores_.add(bottom_absorption_, weight); }
    void unfinished(double weight) { scores_.add(unfinished_, weight); }
    void roulette(double gained) { scores_.add(roulette_, gained); }
    /// All of a photon that leaves where and how it is.
    void leaves(const ScalarPhoton& photon);
    void absorbed(const ScalarPhoton& photon, double weight);

    void end_batch() { scores_.end_batch(); }
    /// Of batches of so many photons.
    MonteCarloResult result(std::size_t batch) const;

private:
    std::size_t r_bin(const ScalarPhoton& photon) const;
    std::size_t alpha_bin(double cosine) const;

    const MonteCarloRequest& request_;
    std::size_t layers_;
    BatchScores scores_;
    std::size_t specular_ = scores_.append(1), diffuse_reflectance_ = scores_.append(1);
    std::size_t unscattered_transmittance_ = scores_.append(1);
    std::size_t diffuse_transmittance_ = scores_.append(1);
    std::size_t absorption_ = scores_.append(layers_);
    std::size_t bottom_absorption_ = scores_.append(1);
    std::size_t unfinished_ = scores_.append(1), roulette_ = scores_.append(1);
    std::size_t reflected_r_ = scores_.append(request_.r_bins + 1);
    std::size_t reflected_alpha_ = scores_.append(request_.alpha_bins);
    std::size_t transmitted_r_ = scores_.append(request_.r_bins + 1);
    std::size_t transmitted_alpha_ = scores_.append(request_.alpha_bins);
    std::size_t absorbed_z_ = scores_.append(request_.z_bins + 1);
    std::size_t absorbed_zr_ = scores_.append((request_.z_bins + 1) * (request_.r_bins + 1));
};

}  // namespace gonio::reference
