// SPDX-License-Identifier: Apache-2.0
// Light transport after Wang, Jacques and Zheng 1995.
#include "reference/scalar_monte_carlo.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <tuple>
#include <utility>

#include "gonio/errors.hpp"
#include "reference/cosine_sampler.hpp"
#include "reference/fresnel.hpp"

namespace gonio::reference {
namespace {

using std::numbers::pi;

struct Photon {
    double x = 0, y = 0, z = 0;  ///< cm; z points down
    double ux = 0, uy = 0, uz = 1;
    double weight = 1;  ///< 0 where its life has ended
    std::size_t layer = 0;
    bool met_matter = false;  ///< has been where light is absorbed or scattered
    bool scattered = false;
};

/// A layer as a photon sees it.
struct Level {
    double top, bottom;  ///< cm
    double n, mua, mut;
    CosineSampler cosine;
};

class Simulation {
public:
    Simulation(const LayeredMedium& medium, const MonteCarloRequest& request);
    MonteCarloResult run();

private:
    double uniform() { return uniform_(); }
    std::size_t r_bin(const Photon& photon) const;
    std::size_t alpha_bin(double cosine) const;

    Photon launch();
    void follow(Photon& photon);
    void meet_boundary(Photon& photon);
    void meet_bottom(Photon& photon);
    void leave(Photon& photon);
    void absorb(Photon& photon);
    void scatter(Photon& photon);
    void turn(Photon& photon, double cosine);
    void play_roulette(Photon& photon);

    const LayeredMedium& medium_;
    const MonteCarloRequest& request_;
    std::vector<Level> levels_;
    std::function<double()> uniform_;

    BatchScores scores_;
    std::size_t specular_ = scores_.append(1), diffuse_reflectance_ = scores_.append(1);
    std::size_t unscattered_transmittance_ = scores_.append(1);
    std::size_t diffuse_transmittance_ = scores_.append(1);
    std::size_t absorption_ = scores_.append(medium_.layers.size());
    std::size_t bottom_absorption_ = scores_.append(1);
    std::size_t unfinished_ = scores_.append(1), roulette_ = scores_.append(1);
    std::size_t reflected_r_ = scores_.append(request_.r_bins + 1);
    std::size_t reflected_alpha_ = scores_.append(request_.alpha_bins);
    std::size_t transmitted_r_ = scores_.append(request_.r_bins + 1);
    std::size_t transmitted_alpha_ = scores_.append(request_.alpha_bins);
    std::size_t absorbed_z_ = scores_.append(request_.z_bins + 1);
    std::size_t absorbed_zr_ = scores_.append((request_.z_bins + 1) * (request_.r_bins + 1));
};

Simulation::Simulation(const LayeredMedium& medium, const MonteCarloRequest& request)
    : medium_(medium), request_(request), uniform_(request.uniform)
{
    if (!uniform_)
        uniform_ = [generator = std::mt19937_64(request.seed)]() mutable {
            return (double(generator() >> 11) + 0.5) * 0x1p-53;
        };
    double depth = 0;
    for (const Layer& layer : medium.layers) {
        levels_.push_back({depth, depth + layer.d, layer.n, layer.mua, layer.mua + layer.mus,
                           CosineSampler(layer.phase)});
        depth += layer.d;
    }
}

std::size_t Simulation::r_bin(const Photon& photon) const
{
    const double bin = std::sqrt(photon.x * photon.x + photon.y * photon.y) / request_.dr;
    return bin < double(request_.r_bins) ? static_cast<std::size_t>(bin) : request_.r_bins;
}

std::size_t Simulation::alpha_bin(double cosine) const
{
    const double bin = std::acos(cosine) / (pi / 2) * double(request_.alpha_bins);
    return std::min(static_cast<std::size_t>(bin), request_.alpha_bins - 1);
}

/// What the first boundary reflects is scored and taken off, and the rest refracted.
Photon Simulation::launch()
{
    Photon photon;
    const double cosine = request_.diffuse ? std::sqrt(uniform()) : std::cos(request_.incidence);
    const double ratio = medium_.n_above / levels_[0].n;
    photon.ux = ratio * std::sqrt((1 - cosine) * (1 + cosine));
    const double reflected = photon.ux < 1 ? fresnel_exact(1 / ratio, 0, cosine) : 1;
    photon.uz = std::sqrt(std::max((1 - photon.ux) * (1 + photon.ux), 0.0));
    photon.weight = 1 - reflected;
    scores_.add(specular_, reflected);
    return photon;
}

/// Steps of random optical length, cut at boundaries; what is left of a step is made behind them.
void Simulation::follow(Photon& photon)
{
    double optical = 0;
    for (std::size_t step = 0; step < request_.most_steps && photon.weight > 0; ++step) {
        const Level& level = levels_[photon.layer];
        if (level.mut > 0) photon.met_matter = true;
        if (optical <= 0) optical = -std::log(uniform());
        const double wall = photon.uz > 0 ? level.bottom : level.top;
        const double to_wall = (wall - photon.z) / photon.uz;
        const bool hits = to_wall * level.mut <= optical;
        const double length = hits ? to_wall : optical / level.mut;
        photon.x += photon.ux * length;
        photon.y += photon.uy * length;
        if (hits) {
            optical -= length * level.mut;
            photon.z = wall;
            meet_boundary(photon);
        } else {
            optical = 0;
            photon.z += photon.uz * length;
            absorb(photon);
            scatter(photon);
            play_roulette(photon);
        }
    }
    scores_.add(unfinished_, photon.weight);
}

/// Section 3.6: light is reflected or refracted as a whole, by chance.
void Simulation::meet_boundary(Photon& photon)
{
    const bool down = photon.uz > 0;
    const bool last = photon.layer + 1 == levels_.size();
    if (down && last && medium_.bottom != Bottom::open) return meet_bottom(photon);
    const double n = levels_[photon.layer].n;
    double n_behind = medium_.n_above;
    if (down)
        n_behind = last ? medium_.n_below : levels_[photon.layer + 1].n;
    else if (photon.layer > 0)
        n_behind = levels_[photon.layer - 1].n;

    if (n != n_behind) {
        const double cosine = std::abs(photon.uz), ratio = n / n_behind;
        const double sine_behind = ratio * std::sqrt((1 - cosine) * (1 + cosine));
        if (sine_behind >= 1 || uniform() < fresnel_exact(1 / ratio, 0, cosine)) {
            photon.uz = -photon.uz;
            return;
        }
        photon.ux *= ratio;
        photon.uy *= ratio;
        photon.uz = std::copysign(std::sqrt((1 - sine_behind) * (1 + sine_behind)), photon.uz);
    }
    if (down ? last : photon.layer == 0) return leave(photon);
    photon.layer = down ? photon.layer + 1 : photon.layer - 1;
}

void Simulation::meet_bottom(Photon& photon)
{
    if (medium_.bottom == Bottom::mirror) {
        photon.uz = -photon.uz;
        return;
    }
    const double kept = medium_.bottom == Bottom::diffuse ? medium_.bottom_albedo : 0;
    scores_.add(bottom_absorption_, photon.weight * (1 - kept));
    photon.weight *= kept;
    photon.met_matter = photon.scattered = true;
    photon.ux = photon.uy = 0;
    photon.uz = -1;
    turn(photon, std::sqrt(uniform()));
}

void Simulation::leave(Photon& photon)
{
    const bool down = photon.uz > 0;
    const double weight = std::exchange(photon.weight, 0);
    if (!down && !photon.met_matter) return scores_.add(specular_, weight);
    if (down && !photon.scattered) return scores_.add(unscattered_transmittance_, weight);
    scores_.add(down ? diffuse_transmittance_ : diffuse_reflectance_, weight);
    if (!photon.scattered) return;
    scores_.add((down ? transmitted_r_ : reflected_r_) + r_bin(photon), weight);
    scores_.add((down ? transmitted_alpha_ : reflected_alpha_) + alpha_bin(std::abs(photon.uz)),
                weight);
}

void Simulation::absorb(Photon& photon)
{
    const Level& level = levels_[photon.layer];
    const double part = level.mua / level.mut;
    const double weight = photon.weight * (request_.analogue ? double(uniform() < part) : part);
    photon.weight -= weight;
    const double bin = photon.z / request_.dz;
    const std::size_t z =
        bin < double(request_.z_bins) ? static_cast<std::size_t>(bin) : request_.z_bins;
    scores_.add(absorption_ + photon.layer, weight);
    scores_.add(absorbed_z_ + z, weight);
    scores_.add(absorbed_zr_ + z * (request_.r_bins + 1) + r_bin(photon), weight);
}

void Simulation::scatter(Photon& photon)
{
    photon.scattered = true;
    turn(photon, levels_[photon.layer].cosine(uniform()));
}

/// Eqs. 3.24 and 3.25, with a uniform azimuth.
void Simulation::turn(Photon& photon, double cosine)
{
    const double sine = std::sqrt((1 - cosine) * (1 + cosine));
    const double azimuth = 2 * pi * uniform();
    const double across = sine * std::cos(azimuth), aside = sine * std::sin(azimuth);
    const auto [ux, uy, uz] = std::tuple(photon.ux, photon.uy, photon.uz);
    const double horizontal = std::sqrt(ux * ux + uy * uy);
    if (horizontal == 0) {
        photon.ux = across;
        photon.uy = aside;
    } else {
        photon.ux = (ux * uz * across - uy * aside) / horizontal + ux * cosine;
        photon.uy = (uy * uz * across + ux * aside) / horizontal + uy * cosine;
    }
    photon.uz = uz * cosine - horizontal * across;
}

void Simulation::play_roulette(Photon& photon)
{
    if (photon.weight >= request_.roulette_below) return;
    const double before = photon.weight;
    photon.weight =
        uniform() < request_.roulette_survival ? before / request_.roulette_survival : 0;
    scores_.add(roulette_, photon.weight - before);
}

MonteCarloResult Simulation::run()
{
    const std::size_t size = (request_.photons + request_.batches - 1) / request_.batches;
    for (std::size_t batch = 0; batch < request_.batches; ++batch) {
        for (std::size_t i = 0; i < size; ++i) {
            if (request_.before_photon) request_.before_photon(batch * size + i);
            Photon photon = launch();
            follow(photon);
        }
        scores_.end_batch();
    }
    const auto one = [&](std::size_t place) { return scores_.estimate(place, size); };
    const auto many = [&](std::size_t first, std::size_t count) {
        return scores_.estimates(first, count, size);
    };
    const std::size_t r_bins = request_.r_bins + 1, z_bins = request_.z_bins + 1;
    return {.specular = one(specular_),
            .diffuse_reflectance = one(diffuse_reflectance_),
            .unscattered_transmittance = one(unscattered_transmittance_),
            .diffuse_transmittance = one(diffuse_transmittance_),
            .absorption = many(absorption_, levels_.size()),
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

}  // namespace

MonteCarloResult simulate(const LayeredMedium& medium, const MonteCarloRequest& request)
{
    validate(medium);
    if (!(request.incidence >= 0 && request.incidence < pi / 2)) {
        throw UsageError(fmt::format("an angle of incidence of {} degrees must be in [0, 90)",
                                     request.incidence * 180 / pi));
    }
    return Simulation(medium, request).run();
}

}  // namespace gonio::reference
