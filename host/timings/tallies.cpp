// SPDX-License-Identifier: Apache-2.0
// Photons in skin by where and when they end: each kind of tally in a run of its own.
#include <algorithm>
#include <cmath>

#include "gonio/quantity.hpp"
#include "photon/bins.hpp"
#include "photon/exact_values.hpp"
#include "timings/photon_errors.hpp"
#include "timings/skin.hpp"

namespace gonio {
namespace {

constexpr std::size_t angles = 9, bins = 20;
constexpr double width = 0.02;      // cm
constexpr double picoseconds = 10;  // in a bin
constexpr double exact_to = 1e-5;   // of the largest value: below what photons reach
constexpr int directions = 64;

/// The reflected light in each bin of the angle.
std::vector<double> exact_angles(const LayeredMedium& medium)
{
    LightJob job{.medium = medium,
                 .quantity = &find_quantity("reflectance_alpha", Substance::layers),
                 .solver = "adding_doubling"};
    job.budget.max_error = exact_to;
    const Axis alpha{"alpha", "degrees", std::vector<double>(angles)};
    std::vector<double> light;
    for (const Fraction& mean : exact_values(job, {alpha}).values)
        light.push_back(mean.mean * solid_angle(light.size(), angles));
    return light;
}

/// The light absorbed in each bin of depth: layers are cut at the bins' ends, which changes nothing
/// but where absorption is counted.
std::vector<double> exact_depths(const LayeredMedium& medium)
{
    constexpr double sliver = 1e-9;
    LayeredMedium cut = medium;
    cut.layers.clear();
    std::vector<std::size_t> bin_of;
    double top = 0;
    for (Layer layer : medium.layers) {
        const double bottom = top + layer.d;
        for (double end = top; top < bottom; top = end) {
            const auto bin = std::min(std::size_t((top + sliver) / width), bins);
            end = bin < bins ? double(bin + 1) * width : bottom;
            if (end + sliver > bottom) end = bottom;
            layer.d = end - top;
            cut.layers.push_back(layer);
            bin_of.push_back(bin);
        }
    }
    const auto solution = reference::solve_layers_once(cut, {.incidence = {0}}, directions);
    std::vector<double> light(bins + 1);
    for (std::size_t k = 0; k < bin_of.size(); ++k)
        light[bin_of[k]] += solution.collimated[0].budget.absorption[k];
    light.resize(bins);
    return light;
}

/// Without what lies beyond the last bin.
auto first_of(std::vector<Fraction> PhotonResult::*tally, std::size_t count)
{
    return [tally, count](const PhotonResult& result) {
        const std::vector<Fraction>& all = result.*tally;
        return std::vector(all.begin(), all.begin() + std::ptrdiff_t(count));
    };
}

}  // namespace

BenchPlot bench_tallies(const BenchRun& run)
{
    BenchPlot plot{
        "tallies", "Light in skin by angle, depth, distance and time",
        "The skin of the photons' plot, each tally in runs of its own: R(alpha) in 9 bins of 10 "
        "degrees, A(z) and R(r) in 20 of 0.02 cm, R(t) in 20 of 10 ps. Roots of the mean square "
        "over bins and several seeds, over that of the light in the bins. R(alpha) and A(z) have a "
        "noise-free answer, by adding-doubling (for A(z) of layers cut at the bins' ends), and so "
        "a true error; R(r) and R(t) have none, and only their standard error is shown.",
        "seconds", "relative error"};
    run.step("tallies: what is right");
    const LayeredMedium medium = benchmark_skin();
    const int most_power = run.quick ? 14 : 20;
    add_photons(plot, run, {.reflected = true, .angles = angles},
                {{"R(alpha)", exact_angles(medium), first_of(&PhotonResult::reflected, angles)}},
                most_power);
    add_photons(plot, run, {.absorbed = true, .depth_width = width, .depths = bins},
                {{"A(z)", exact_depths(medium), first_of(&PhotonResult::absorbed, bins)}},
                most_power);
    add_photons(plot, run, {.reflected = true, .radius_width = width, .rows = bins},
                {{"R(r)", {}, first_of(&PhotonResult::reflected, bins)}}, most_power);
    add_photons(plot, run,
                {.reflected = true, .row = ExitRow::time, .time_width = picoseconds, .rows = bins},
                {{"R(t)", {}, first_of(&PhotonResult::reflected, bins)}}, most_power);
    add_slope(plot);
    return plot;
}

}  // namespace gonio
