// SPDX-License-Identifier: Apache-2.0
// A split sum of GGX, 64 x 64: by quadrature on the device, and by the usual sampling in C++. Times
// are those of a clock on the wall, with everything but the building of the program.
//   mean_error, max_error  against the reference's quadrature in double, at every seventh cell of
//                          both directions
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

#include "gonio/job.hpp"
#include "quadrature/derived.hpp"
#include "quadrature/hammersley.hpp"
#include "reference/albedo.hpp"

namespace gonio {
namespace {

constexpr std::size_t size = 64, first = 3, step = 7;

Job split_sum_job()
{
    return plan_jobs(parse_scene("[[material]]\nname = \"ggx\"\nmodel = \"ggx\"\n[[table]]\n"
                                 "material = \"ggx\"\nquantity = \"dfg\"\n[table.axes]\n"
                                 "alpha = { to = 1, count = 64, spacing = \"square\" }\n"
                                 "mu = { to = 1, count = 64 }\n",
                                 "split_sum"))
        .front();
}

struct Right {
    std::size_t cell;
    double scale, bias;
};

const std::vector<Right>& right_cells()
{
    static const std::vector<Right> cells = [] {
        const Job job = split_sum_job();
        std::vector<Right> all;
        for (std::size_t row = first; row < size; row += step)
            for (std::size_t column = first; column < size; column += step) {
                const std::size_t k = row * size + column;
                const double mu = job.cells[k].at.cosine;
                const glm::dvec3 v(std::sqrt(1 - mu * mu), 0, mu);
                Material material = job.materials[job.cells[k].material];
                material.lobes[0].set("f0", std::vector{1.0, 0.0});
                const Reference f = make_reference(material, Measure::brdf);
                const double albedo = reference::hemispherical_directional(f, v, 0, 1e-7);
                const double bias = reference::hemispherical_directional(f, v, 1, 1e-7);
                all.push_back({k, albedo - bias, bias});
            }
        return all;
    }();
    return cells;
}

template <class Planes>
void report(benchmark::State& state, const Planes& scale, const Planes& bias)
{
    double sum = 0, greatest = 0;
    for (const Right& right : right_cells())
        for (const double error : {static_cast<double>(scale[right.cell]) - right.scale,
                                   static_cast<double>(bias[right.cell]) - right.bias}) {
            sum += std::abs(error);
            greatest = std::max(greatest, std::abs(error));
        }
    state.counters["mean_error"] = sum / (2 * static_cast<double>(right_cells().size()));
    state.counters["max_error"] = greatest;
}

void quadrature(benchmark::State& state)
{
    const Device device;
    Job job = split_sum_job();
    job.max_error = std::pow(10.0, -static_cast<double>(state.range(0)));
    DerivedTable table = derive(device, job);
    for (auto _ : state) table = derive(device, job);
    report(state, table.values[0], table.values[1]);
    state.counters["evaluations"] = static_cast<double>(table.spent.evaluated);
}

void hammersley(benchmark::State& state)
{
    std::vector<float> scale(size * size), bias(size * size);
    for (auto _ : state)
        bench::hammersley_split_sum(scale.data(), bias.data(), size,
                                    static_cast<unsigned>(state.range(0)));
    report(state, scale, bias);
}

BENCHMARK(quadrature)
    ->Name("split_sum/quadrature/max_error_1e-")
    ->Arg(3)
    ->Arg(6)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(hammersley)
    ->Name("split_sum/hammersley/samples")
    ->Arg(64)
    ->Arg(1024)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gonio
