// SPDX-License-Identifier: Apache-2.0
// The layers that a table needs.
#include "photon/asked_layers.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "photon/bins.hpp"
#include "reference/adding_doubling.hpp"

namespace gonio {
namespace {

using std::numbers::pi;

constexpr int nodes = 16;         // of a solution that tells how deep light comes
constexpr double uncertain = 10;  // times that, since it is coarse
constexpr double of_error = 0.1;  // of the error asked for may come from layers left out
constexpr double cm_per_ps = 0.0299792458;

bool tells_no_distance(std::string_view quantity)
{
    return quantity == "directional_albedo" || quantity == "mean_albedo" || quantity == "brdf" ||
           quantity == "reflectance_alpha" || quantity == "transmittance_alpha";
}

bool is_clear(const Layer& layer)
{
    return layer.mua + layer.mus == 0;
}

/// Without clear layers of the index above or below them, where light goes straight on.
std::size_t drop_clear_layers(LayeredMedium& medium)
{
    const std::size_t all = medium.layers.size();
    for (std::size_t k = 0; k < medium.layers.size() && medium.layers.size() > 1;) {
        const double n = medium.layers[k].n;
        const bool first = k == 0, last = k + 1 == medium.layers.size();
        const double above = first ? medium.n_above : medium.layers[k - 1].n;
        const bool open = !last || medium.bottom == Bottom::open;
        const double below = last ? medium.n_below : medium.layers[k + 1].n;
        if (is_clear(medium.layers[k]) && (n == above || (open && n == below)))
            medium.layers.erase(medium.layers.begin() + static_cast<std::ptrdiff_t>(k));
        else
            ++k;
    }
    return all - medium.layers.size();
}

/// What becomes of light above a depth: comes_so_far is the part that arrives there at all, and
/// reflected what leaves the surface without having been there.
struct Upper {
    double comes_so_far = 0;
    double reflected = 1;
};

/// Of the light that carries farthest, and of that which is reflected least.
Upper upper_part(const LayeredMedium& medium, std::size_t count, const Job& job)
{
    LayeredMedium upper = medium;
    upper.layers.resize(count);
    upper.bottom = Bottom::black;
    reference::LightRequest request;
    const LightSource& light = job.layers->light;
    if (job.layers->quantity->id == "directional_albedo")
        for (const double mu : job.header.axes.front().values)
            request.incidence.push_back(std::acos(mu));
    else if (light.beam != Beam::diffuse)
        request.incidence.push_back(light.incidence);
    const auto solution = reference::solve_layers_once(upper, request, nodes);
    Upper result;
    const auto see = [&](const reference::LightBudget& budget) {
        result.comes_so_far = std::max(result.comes_so_far, budget.bottom_absorption);
        result.reflected = std::min(result.reflected, budget.diffuse_reflectance);
    };
    if (request.incidence.empty()) see(solution.diffuse.budget);
    for (const reference::Illumination& one : solution.collimated) see(one.budget);
    return result;
}

/// How long the paths are of at least half the light that is reflected: what has come farther has
/// lost more. Infinite where a layer absorbs nothing.
double longest_path(const LayeredMedium& medium, std::size_t count, double reflected)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < count; ++k) least = std::min(least, medium.layers[k].mua);
    return std::log(2 / reflected) / least;
}

/// The part of the light that changes no value of the table by more than its error if it goes
/// astray: all of it into the smallest bin, over the largest value. That is at least what half of
/// the reflected light makes, spread over the area, angles or times that it can have reached; bins
/// begin where it is brightest.
double allowed(const Job& job, const LayeredMedium& medium, std::size_t count, double reflected)
{
    const double error = of_error * *job.layers->budget.max_error;
    if (job.header.axes.empty() || job.header.axes.front().name == "mu") return error;
    const PhotonTallies tallies = tallies_of(*job.layers->quantity, job.header.axes);
    double part = error * reflected / 2;
    if (tallies.angles > 1) part *= solid_angle(0, tallies.angles) / (2 * pi);
    if (tallies.rows == 0) return part;
    const double path = longest_path(medium, count, reflected);
    if (tallies.row == ExitRow::radius) {
        const double radius = path + 3 * job.layers->light.radius;
        return part * ring_area(0, tallies.radius_width) / (pi * radius * radius);
    }
    double index = 0;
    for (std::size_t k = 0; k < count; ++k) index = std::max(index, medium.layers[k].n);
    return part * tallies.time_width * cm_per_ps / (path * index);
}

/// The part of the light below these layers that ever leaves through them, were all that comes back
/// down reflected again: of the direction in which most passes, and of that in which most is thrown
/// back.
double leaves_from_below(const LayeredMedium& medium, std::size_t count)
{
    const auto end = medium.layers.rend();
    const LayeredMedium turned{.n_above = medium.layers[count - 1].n,
                               .n_below = medium.n_above,
                               .layers = {end - static_cast<std::ptrdiff_t>(count), end}};
    double passes = 0, thrown_back = 0;
    const auto solution =
        reference::solve_layers_once(turned, {.incidence = {0, 0.5, 1, 1.4}}, nodes);
    for (const reference::Illumination& one : solution.collimated) {
        const reference::LightBudget& budget = one.budget;
        passes = std::max(passes, budget.unscattered_transmittance + budget.diffuse_transmittance);
        thrown_back = std::max(thrown_back, budget.specular + budget.diffuse_reflectance);
    }
    return thrown_back < 1 ? std::min(1.0, passes / (1 - thrown_back)) : 1;
}

void cut(AskedLayers& asked, const Job& job)
{
    LayeredMedium& medium = asked.medium;
    for (std::size_t count = 1; count < medium.layers.size(); ++count) {
        if (is_clear(medium.layers[count - 1])) continue;  // it could have no end
        const Upper upper = upper_part(medium, count, job);
        const double returned = uncertain * std::max(upper.comes_so_far, 0x1p-50) *
                                std::max(leaves_from_below(medium, count), 0x1p-50);
        if (!(upper.reflected > 0 && returned <= allowed(job, medium, count, upper.reflected)))
            continue;
        asked.unreached = medium.layers.size() - count;
        asked.returned = returned;
        medium.layers.resize(count);
        medium.layers.back().d = std::numeric_limits<double>::infinity();
        medium.bottom = Bottom::open;
        return;
    }
}

}  // namespace

AskedLayers asked_layers(const Job& job)
{
    AskedLayers asked{job.layers->medium};
    const std::string_view id = job.layers->quantity->id;
    if (tells_no_distance(id)) asked.clear = drop_clear_layers(asked.medium);
    const bool reflected = id.starts_with("reflectance") || id.ends_with("albedo");
    if (reflected && job.layers->budget.max_error) cut(asked, job);
    return asked;
}

}  // namespace gonio
