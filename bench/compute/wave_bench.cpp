// SPDX-License-Identifier: Apache-2.0
// The wave-optics models, whose cost depends on the surface: on the device and in the scalar
// reference, which sums the same series in double.
//   terms         of the series that are above 2^-25 of its sum, per evaluation, mean over the grid
//   Geval_per_s   evaluations per second, all compute units
//   vs_scalar     per compute unit, times the scalar reference on one core
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "gonio/compute.hpp"
#include "gonio/grid.hpp"

namespace gonio {
namespace {

using std::numbers::pi;

constexpr std::size_t thetas = 32, columns = 1024;

/// Terms from the first to the last that matters of e^-g g^m/(m! m) e^(-b/m).
double series_terms(double g, double b)
{
    std::vector<double> terms;
    double sum = 0;
    for (int m = 1; m < 4 * g + 100; ++m) {
        terms.push_back(std::exp(m * std::log(g) - g - std::lgamma(m + 1) - b / m) / m);
        sum += terms.back();
    }
    const auto last = std::find_if(terms.rbegin(), terms.rend(),
                                   [&](double term) { return term > sum * 0x1p-25; });
    return static_cast<double>(terms.rend() - last);
}

double terms_of(const Lobe& lobe, glm::dvec3 l, glm::dvec3 v)
{
    const auto number = [&](std::string_view name) {
        return lobe.number(lobe.model->index_of(name), 0);
    };
    const double per_um = 1000 / number("wavelength");
    const double phase = 2 * pi * number("sigma") * per_um * (l.z + v.z);
    const double across = pi * number("tau") * per_um * std::hypot(l.x + v.x, l.y + v.y);
    return series_terms(phase * phase, across * across);
}

/// Every 971st cell of the grid.
std::vector<std::pair<glm::dvec3, glm::dvec3>> sample_of(const Grid& grid)
{
    std::vector<std::pair<glm::dvec3, glm::dvec3>> pairs;
    const GridVectors vectors(grid);
    for (std::size_t cell = 0; cell < thetas * thetas * columns; cell += 971)
        pairs.push_back(vectors.at(cell / columns, cell % columns));
    return pairs;
}

void wave(benchmark::State& state, const std::string& model)
{
    const Device device;
    Lobe lobe = default_lobe(model);
    lobe.set("sigma", std::vector{static_cast<double>(state.range(0)) / 1000});
    const Material material{model, {lobe}};
    const Grid grid = isotropic_grid(thetas, thetas, columns, Samples::centre, 180);
    const auto pairs = sample_of(grid);
    const Reference reference = make_reference(material, Measure::brdf);

    double own = INFINITY, scalar = INFINITY;
    for (auto _ : state) {
        own = std::min(own, compute_grid(device, material, Measure::brdf, grid,
                                         [](const Rows<float>&) {}, {.leave_out = false})
                                .kernel_seconds);
        const auto start = std::chrono::steady_clock::now();
        for (const auto& [l, v] : pairs) benchmark::DoNotOptimize(reference(l, v, 0));
        scalar = std::min(
            scalar,
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    const double per_second = static_cast<double>(thetas * thetas * columns) / own;
    double terms = 0;
    for (const auto& [l, v] : pairs) terms += terms_of(lobe, l, v);
    state.counters["terms"] = terms / static_cast<double>(pairs.size());
    state.counters["Geval_per_s"] = per_second * 1e-9;
    state.counters["vs_scalar"] =
        per_second / device.info().compute_units * scalar / static_cast<double>(pairs.size());
}

const bool registered = [] {
    for (const auto model : {"beckmann_kirchhoff", "vernold_harvey", "he_torrance", "harvey_shack"})
        benchmark::RegisterBenchmark((std::string("wave/") + model + "/sigma_nm").c_str(),
                                     [model](benchmark::State& state) { wave(state, model); })
            ->Arg(20)
            ->Arg(200)
            ->Arg(2000)
            ->Iterations(5)
            ->Unit(benchmark::kMillisecond);
    return true;
}();

}  // namespace
}  // namespace gonio
