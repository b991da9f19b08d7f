// SPDX-License-Identifier: Apache-2.0
// Light transport after Wang, Jacques and Zheng 1995.
#include "reference/scalar_monte_carlo.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "gonio/errors.hpp"
#include "reference/cosine_sampler.hpp"
#include "reference/fresnel.hpp"
#include "reference/scalar_tallies.hpp"

namespace gonio::reference {
namespace {

using std::numbers::pi;

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
    double azimuth() { return 2 * pi * uniform(); }

    ScalarPhoton launch();
    void follow(ScalarPhoton& photon);
    void meet_boundary(ScalarPhoton& photon);
    void meet_bottom(ScalarPhoton& photon);
    void absorb(ScalarPhoton& photon);
    void scatter(ScalarPhoton& photon);
    void play_roulette(ScalarPhoton& photon);

    const LayeredMedium& medium_;
    const MonteCarloRequest& request_;
    std::vector<Level> levels_;
    std::function<double()> uniform_;
    ScalarTallies tallies_;
};

Simulation::Simulation(const LayeredMedium& medium, const MonteCarloRequest& request)
    : medium_(medium),
      request_(request),
      uniform_(request.uniform),
      tallies_(request, medium.layers.size())
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

/// What the first boundary reflects is scored and taken off, and the rest refracted.
ScalarPhoton Simulation::launch()
{
    ScalarPhoton photon;
    const double cosine = request_.diffuse ? std::sqrt(uniform()) : std::cos(request_.incidence);
    const double ratio = medium_.n_above / levels_[0].n;
    photon.ux = ratio * std::sqrt((1 - cosine) * (1 + cosine));
    const double reflected = photon.ux < 1 ? fresnel_exact(1 / ratio, 0, cosine) : 1;
    photon.uz = std::sqrt(std::max((1 - photon.ux) * (1 + photon.ux), 0.0));
    photon.weight = 1 - reflected;
    tallies_.specular(reflected);
    return photon;
}

/// Steps of random optical length, cut at boundaries; what is left of a step is made behind them.
void Simulation::follow(ScalarPhoton& photon)
{
    double optical = 0;
    for (std::size_t step = 0; step < request_.most_steps && photon.weight > 0; ++step) {
        const Level& level = levels_[photon.layer];
        if (level.mut > 0) photon.met_matter = true;
        if (optical <= 0) optical = -std::log(uniform());
        const double wall = photon.goes_down() ? level.bottom : level.top;
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
    tallies_.unfinished(photon.weight);
}

/// Section 3.6: light is reflected or refracted as a whole, by chance.
void Simulation::meet_boundary(ScalarPhoton& photon)
{
    const bool down = photon.goes_down();
    const bool last = photon.layer + 1 == levels_.size();
    if (down && last && medium_.bottom != Bottom::open) return meet_bottom(photon);
    const double n = levels_[photon.layer].n;
    double n_behind = medium_.n_above;
    if (down)
        n_behind = last ? medium_.n_below : levels_[photon.layer + 1].n;
    else if (photon.layer > 0)
        n_behind = levels_[photon.layer - 1].n;

    const double cosine = std::abs(photon.uz), ratio = n / n_behind;
    const double sine_behind = ratio * std::sqrt((1 - cosine) * (1 + cosine));
    const bool total = sine_behind >= 1;
    double reflectance = 0;
    if (n != n_behind) reflectance = total ? 1 : fresnel_exact(1 / ratio, 0, cosine);
    const bool draws = request_.draws_at_all_boundaries || (n != n_behind && !total);
    if ((draws ? uniform() : 0.5) < reflectance) {
        photon.uz = -photon.uz;
        return;
    }
    if (n != n_behind) {
        photon.ux *= ratio;
        photon.uy *= ratio;
        photon.uz = std::copysign(std::sqrt((1 - sine_behind) * (1 + sine_behind)), photon.uz);
    }
    if (down ? last : photon.layer == 0) {
        tallies_.leaves(photon);
        photon.weight = 0;
        return;
    }
    photon.layer = down ? photon.layer + 1 : photon.layer - 1;
}

void Simulation::meet_bottom(ScalarPhoton& photon)
{
    if (medium_.bottom == Bottom::mirror) {
        photon.uz = -photon.uz;
        return;
    }
    const double kept = medium_.bottom == Bottom::diffuse ? medium_.bottom_albedo : 0;
    tallies_.bottom(photon.weight * (1 - kept));
    photon.weight *= kept;
    photon.met_matter = photon.scattered = true;
    photon.ux = photon.uy = 0;
    photon.uz = -1;
    const double cosine = std::sqrt(uniform());
    photon.turn(cosine, azimuth());
}

void Simulation::absorb(ScalarPhoton& photon)
{
    const Level& level = levels_[photon.layer];
    const double part = level.mua / level.mut;
    const double weight = photon.weight * (request_.analogue ? double(uniform() < part) : part);
    photon.weight -= weight;
    tallies_.absorbed(photon, weight);
}

void Simulation::scatter(ScalarPhoton& photon)
{
    photon.scattered = true;
    const double cosine = levels_[photon.layer].cosine(uniform());
    photon.turn(cosine, azimuth());
}

void Simulation::play_roulette(ScalarPhoton& photon)
{
    if (photon.weight >= request_.roulette_below) return;
    const double before = photon.weight;
    photon.weight =
        uniform() < request_.roulette_survival ? before / request_.roulette_survival : 0;
    tallies_.roulette(photon.weight - before);
}

MonteCarloResult Simulation::run()
{
    const std::size_t size = (request_.photons + request_.batches - 1) / request_.batches;
    for (std::size_t batch = 0; batch < request_.batches; ++batch) {
        for (std::size_t i = 0; i < size; ++i) {
            if (request_.before_photon) request_.before_photon(batch * size + i);
            ScalarPhoton photon = launch();
            follow(photon);
        }
        tallies_.end_batch();
    }
    return tallies_.result(size);
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
