// SPDX-License-Identifier: Apache-2.0
// Makes the table of a job with layers: by adding-doubling, or by Monte Carlo until a budget ends.
#include "photon/light_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "gonio/errors.hpp"
#include "gonio/photons.hpp"
#include "photon/bins.hpp"
#include "reference/adding_doubling.hpp"
#include "scene/located.hpp"

namespace gonio {
namespace {

constexpr std::uint64_t free_batch = std::uint64_t{1} << 15;  // where no number is given
constexpr double default_tolerance = 1e-6;

double largest_error(const std::vector<Fraction>& values)
{
    double value = 0, error = 0;
    for (const Fraction& one : values) {
        value = std::max(value, one.mean);
        error = std::max(error, one.error);
    }
    return value > 0 ? error / value : 0;
}

void write(const Job& job, const std::vector<Fraction>& values)
{
    Table table{job.header, {}};
    if (job.layers->quantity->axes.empty()) {
        for (const Fraction& value : values) table.values.push_back({value.mean});
        for (const Fraction& value : values) table.values.push_back({value.error});
    } else {
        table.values.resize(2);
        for (const Fraction& value : values) {
            table.values[0].push_back(value.mean);
            table.values[1].push_back(value.error);
        }
    }
    write_table(job.path, job.format, table, job.write);
}

LightTable solve(const Job& job)
{
    const LightJob& light = *job.layers;
    const auto solution =
        reference::solve_layers_to(light.medium, {.incidence = {light.light.incidence}},
                                   light.budget.max_error.value_or(default_tolerance));
    const auto& budget = (light.light.diffuse ? solution.diffuse : solution.collimated[0]).budget;
    std::vector<Fraction> values;
    for (const double part :
         {budget.specular, budget.diffuse_reflectance, budget.unscattered_transmittance,
          budget.diffuse_transmittance, budget.bottom_absorption})
        values.push_back({part, solution.error});
    for (const double part : budget.absorption) values.push_back({part, solution.error});
    write(job, values);
    return {0, 0, largest_error(values), {{"nodes", solution.nodes}, {"error", solution.error}}};
}

/// Monte Carlo batch by batch: whether to go on is asked where one ends, so that the answer depends
/// on the request alone, except for time.
class Simulation {
public:
    Simulation(const Device& device, const Job& job)
        : job_(job),
          light_(*job.layers),
          tallies_(tallies_of(*light_.quantity, job.header.axes)),
          most_(most_photons()),
          tracer_(device, light_.medium, {light_.light, tallies_, light_.seed, 0, batch()})
    {
    }

    LightTable run(const Device& device,
                   const std::function<void(const LightProgress&)>& after_launch)
    {
        do {
            tracer_.trace(std::min(batch(), most_ - done_), [&](std::uint64_t count) {
                done_ += count;
                after_launch({fraction(), rate(), error_});
            });
            values_ = densities(tracer_.result(), *light_.quantity, tallies_);
            error_ = largest_error(values_);
        } while (done_ < most_ && !is_exact_enough() && seconds() < time());
        if (job_.must_reach && !is_exact_enough())
            throw RunError(fmt::format(
                "after {} photons and {:.1f} s the largest standard error of table `{}` is {:.2g} "
                "of its largest value, and not {:.2g}; give it more, or --best-effort",
                done_, seconds(), job_.name, error_, *light_.budget.max_error));
        write(job_, values_);
        return {done_, rate(), error_, information(device)};
    }

private:
    std::uint64_t most_photons() const { return light_.budget.photons.value_or(UINT64_MAX); }

    std::uint64_t batch() const { return most_ == UINT64_MAX ? free_batch : batch_of(most_); }

    double time() const { return light_.budget.seconds.value_or(INFINITY); }

    double seconds() const
    {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

    bool is_exact_enough() const
    {
        return light_.budget.max_error && error_ <= *light_.budget.max_error;
    }

    double rate() const { return static_cast<double>(done_) / tracer_.kernel_seconds(); }

    /// The error falls with the root of the number of photons.
    double fraction() const
    {
        double part = seconds() / time();
        if (most_ != UINT64_MAX)
            part = std::max(part, static_cast<double>(done_) / static_cast<double>(most_));
        if (light_.budget.max_error && std::isfinite(error_))
            part = std::max(part, std::pow(*light_.budget.max_error / error_, 2));
        return std::min(part, 1.0);
    }

    nlohmann::ordered_json information(const Device& device) const
    {
        const PhotonResult result = tracer_.result();
        nlohmann::ordered_json run = {{"device", device.info().name},
                                      {"platform", device.info().platform_name},
                                      {"driver", device.info().driver},
                                      {"width", device.width()},
                                      {"photons", done_},
                                      {"kernel_seconds", tracer_.kernel_seconds()},
                                      {"error_of_largest_value", error_},
                                      {"unfinished", result.unfinished.mean}};
        if (!light_.quantity->axes.empty()) run["beyond_the_bins"] = overflow(result, tallies_);
        return run;
    }

    const Job& job_;
    const LightJob& light_;
    PhotonTallies tallies_;
    std::uint64_t most_;
    PhotonTracer tracer_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::uint64_t done_ = 0;
    std::vector<Fraction> values_;
    double error_ = INFINITY;
};

}  // namespace

LightTable make_light_table(const Device& device, const Job& job,
                            const std::function<void(const LightProgress&)>& after_launch)
{
    if (job.layers->solver == "adding_doubling") return solve(job);
    return located(job.where, [&] { return Simulation(device, job).run(device, after_launch); });
}

}  // namespace gonio
