// SPDX-License-Identifier: Apache-2.0
// A split sum of GGX by quadrature on the device, and by sampling in C++.
#include <fmt/format.h>

#include <cmath>

#include "gonio/job.hpp"
#include "parallel.hpp"
#include "quadrature/derived.hpp"
#include "reference/albedo.hpp"
#include "timings/sampled_split_sum.hpp"
#include "timings/sections.hpp"

namespace gonio {
namespace {

constexpr std::size_t size = 64, first = 3;

Job split_sum_job()
{
    return plan_jobs(
               parse_scene(fmt::format("[[material]]\nname = \"ggx\"\nmodel = \"ggx\"\n[[table]]\n"
                                       "material = \"ggx\"\nquantity = \"dfg\"\n[table.axes]\n"
                                       "alpha = {{ to = 1, count = {0}, spacing = \"square\" }}\n"
                                       "mu = {{ to = 1, count = {0} }}\n",
                                       size),
                           "split_sum"))
        .front();
}

struct RightCell {
    std::size_t cell;
    double scale = 0, bias = 0;
};

/// Some cells by the reference's quadrature in double: every so many of both directions.
std::vector<RightCell> right_cells(const Job& job, std::size_t step)
{
    std::vector<RightCell> cells;
    for (std::size_t row = first; row < size; row += step)
        for (std::size_t column = first; column < size; column += step)
            cells.push_back({row * size + column});
    in_parallel(cells.size(), [&](std::size_t k) {
        const IntegralCell& at = job.cells[cells[k].cell];
        Material material = job.materials[at.material];
        material.lobes[0].set("f0", std::vector{1.0, 0.0});
        const Reference f = make_reference(material, Measure::brdf);
        const glm::dvec3 v = unit_vector(at.at);
        cells[k].bias = reference::hemispherical_directional(f, v, 1, 1e-7);
        cells[k].scale = reference::hemispherical_directional(f, v, 0, 1e-7) - cells[k].bias;
    });
    return cells;
}

template <class Plane>
double mean_error(const std::vector<RightCell>& right, const Plane& scale, const Plane& bias)
{
    double sum = 0;
    for (const RightCell& cell : right)
        sum += std::abs(double(scale[cell.cell]) - cell.scale) +
               std::abs(double(bias[cell.cell]) - cell.bias);
    return sum / (2 * double(right.size()));
}

}  // namespace

BenchPlot bench_split_sum(const BenchRun& run)
{
    BenchPlot plot{"split-sum", "A split sum of GGX, 64 x 64",
                   "Quadrature on the device, and importance sampling in float in C++ on all "
                   "processors, without the building of programs. Errors against the reference's "
                   "quadrature in double, at some cells all over the table.",
                   "seconds", "mean error"};
    run.step("split-sum: what is right");
    Job job = split_sum_job();
    const std::vector<RightCell> right = right_cells(job, run.quick ? 20 : 7);
    std::vector<Candidate> candidates;
    const auto add = [&](const std::string& series, const std::string& label, auto make) {
        run.step(fmt::format("split-sum: {} {}", series, label));
        const auto [scale, bias] = make();
        BenchPoint point{series, label, {}, exactly(mean_error(right, scale, bias))};
        candidates.push_back(
            {std::move(point), [make] { return seconds_on_the_wall([&] { make(); }); }});
    };
    for (int digits = 2; digits <= 7; ++digits) {
        job.max_error = std::pow(10.0, -digits);
        add("quadrature", fmt::format("max_error 1e-{}", digits), [&run, job] {
            DerivedTable table = derive(run.device, job);
            return std::pair(std::move(table.values[0]), std::move(table.values[1]));
        });
    }
    const unsigned most = run.quick ? 1024 : 16384;
    for (const auto& [set, name] : {std::pair{SampleSet::hammersley, "Hammersley's set"},
                                    std::pair{SampleSet::random, "random samples"}})
        for (unsigned samples = 16; samples <= most; samples *= 4)
            add(name, fmt::format("{} samples", samples), [set = set, samples] {
                SampledSplitSum table = sampled_split_sum(size, samples, set);
                return std::pair(std::move(table.scale), std::move(table.bias));
            });
    time_in_turn(plot, std::move(candidates), run.rounds());
    mark_best(plot);
    return plot;
}

}  // namespace gonio
