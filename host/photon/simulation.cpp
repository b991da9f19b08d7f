// SPDX-License-Identifier: Apache-2.0
// A table of layers by Monte Carlo, until a budget ends.
#include "photon/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gonio/errors.hpp"
#include "photon/bins.hpp"
#include "photon/checkpoint.hpp"
#include "stopwatch.hpp"

namespace gonio {
namespace {

/// So many photons are enough to give up where no light comes.
constexpr std::uint64_t enough_in_the_dark = std::uint64_t{1} << 24;

/// The largest over the largest value; infinite where no light has come, which tells nothing.
double error_of(const std::vector<Fraction>& values)
{
    const bool dark =
        std::ranges::all_of(values, [](const Fraction& one) { return one.mean == 0; });
    return dark ? INFINITY : largest_error(values);
}

/// Batch by batch: whether to go on is asked where one ends, so that the answer depends on the
/// request alone, except for time.
class Simulation {
public:
    Simulation(const Device& device, const Job& job,
               const std::function<void(const LightProgress&)>& after_launch)
        : device_(device),
          job_(job),
          light_(*job.layers),
          after_launch_(after_launch),
          lights_(lights_of(job)),
          tallies_(tallies_of(*light_.quantity, job.header.axes)),
          most_(light_.budget.photons.value_or(no_limit)),
          checkpoint_(job.path,
                      fmt::format("{}{} layers", definition(job), light_.medium.layers.size()))
    {
    }

    SimulatedValues run()
    {
        const nlohmann::ordered_json saved = checkpoint_.progress();
        if (!saved.is_null()) load(saved);
        for (; part_ < lights_.size(); ++part_) trace_part(saved);
        const double error = error_of(values_);
        return {values_,
                {.photons = photons_,
                 .photons_per_second = rate(),
                 .error = error,
                 .run = information(error)}};
    }

private:
    void trace_part(const nlohmann::ordered_json& saved)
    {
        // Photons of other parts have other numbers, so that their noise is independent.
        PhotonTracer tracer(
            device_, light_.medium,
            {lights_[part_], tallies_, light_.seed, std::uint64_t{part_} << 48, largest_batch});
        done_ = 0;
        spent_ = 0;
        if (!saved.is_null() && saved.at("part") == part_) {
            restore(tracer, saved.at("tracer"));
            done_ = saved.at("done");
            spent_ = saved.at("spent");
        }
        since_ = {};
        std::vector<Fraction> found;
        double error = INFINITY;
        // The batch at hand, which an earlier run may have begun, or ended.
        std::uint64_t end = batch_from(0, most_), batches = 1;
        for (; end < done_; ++batches) end += batch_from(end, most_);
        for (;; end += batch_from(end, most_), ++batches) {
            tracer.trace(std::min(end, most_) - done_, [&](std::uint64_t count) {
                done_ += count;
                report(tracer, error);
            });
            found = densities(tracer.result(), *light_.quantity, tallies_, job_.header.axes);
            if (batches >= least_batches) error = error_of(found);
            if (done_ == most_ || is_exact_enough(error) || seconds() >= time()) break;
            if (std::isinf(error) && is_open_ended() && done_ >= enough_in_the_dark) break;
        }
        error = error_of(found);
        if (job_.must_reach && std::isinf(error))
            throw RunError(fmt::format(
                "none of {} photons has come to table `{}`, so that nothing tells its error; "
                "--best-effort keeps it",
                done_, job_.name));
        if (job_.must_reach && !is_exact_enough(error))
            throw RunError(fmt::format(
                "after {} photons and {:.1f} s the largest standard error of table `{}` is {:.2g} "
                "of its largest value, and not {:.2g}; give it more, or --best-effort",
                done_, seconds(), job_.name, error, *light_.budget.max_error));
        values_.insert(values_.end(), found.begin(), found.end());
        finish(tracer);
    }

    void report(const PhotonTracer& tracer, double error)
    {
        try {
            const double traced = static_cast<double>(photons_ + done_);
            after_launch_(
                {fraction(error), traced / (kernel_seconds_ + tracer.kernel_seconds()), error});
        } catch (...) {
            save(tracer);
            throw;
        }
        if (checkpoint_.is_due()) save(tracer);
    }

    void save(const PhotonTracer& tracer)
    {
        nlohmann::ordered_json finished = nlohmann::ordered_json::array();
        for (const Fraction& value : values_) finished.push_back({value.mean, value.error});
        checkpoint_.save({{"part", part_},
                          {"done", done_},
                          {"spent", seconds()},
                          {"values", finished},
                          {"photons", photons_},
                          {"kernel_seconds", kernel_seconds_},
                          {"unfinished", unfinished_},
                          {"beyond", beyond_},
                          {"tracer", state_of(tracer)}});
    }

    void load(const nlohmann::ordered_json& saved)
    {
        part_ = saved.at("part");
        for (const auto& value : saved.at("values")) values_.push_back({value[0], value[1]});
        photons_ = saved.at("photons");
        kernel_seconds_ = saved.at("kernel_seconds");
        unfinished_ = saved.at("unfinished");
        beyond_ = saved.at("beyond");
    }

    void finish(const PhotonTracer& tracer)
    {
        const PhotonResult result = tracer.result();
        photons_ += done_;
        kernel_seconds_ += tracer.kernel_seconds();
        unfinished_ = std::max(unfinished_, result.unfinished.mean);
        if (!light_.quantity->axes.empty()) beyond_ = overflow(result, tallies_);
    }

    double time() const
    {
        return light_.budget.seconds.value_or(INFINITY) / static_cast<double>(lights_.size());
    }

    double seconds() const { return spent_ + since_.seconds(); }

    bool is_open_ended() const { return most_ == no_limit && !light_.budget.seconds; }

    bool is_exact_enough(double error) const
    {
        return light_.budget.max_error && error <= *light_.budget.max_error;
    }

    double rate() const { return static_cast<double>(photons_) / kernel_seconds_; }

    /// The error falls with the root of the number of photons.
    double fraction(double error) const
    {
        double part = seconds() / time();
        if (most_ != no_limit)
            part = std::max(part, static_cast<double>(done_) / static_cast<double>(most_));
        if (light_.budget.max_error && std::isfinite(error))
            part = std::max(part, std::pow(*light_.budget.max_error / error, 2));
        return (static_cast<double>(part_) + std::min(part, 1.0)) /
               static_cast<double>(lights_.size());
    }

    nlohmann::ordered_json information(double error) const
    {
        nlohmann::ordered_json run = {{"device", device_.info().name},
                                      {"platform", device_.info().platform_name},
                                      {"driver", device_.info().driver},
                                      {"width", device_.width()},
                                      {"photons", photons_},
                                      {"kernel_seconds", kernel_seconds_},
                                      {"error_of_largest_value", error},
                                      {"unfinished", unfinished_}};
        if (!light_.quantity->axes.empty()) run["beyond_the_bins"] = beyond_;
        return run;
    }

    const Device& device_;
    const Job& job_;
    const LightJob& light_;
    const std::function<void(const LightProgress&)>& after_launch_;
    std::vector<LightSource> lights_;
    PhotonTallies tallies_;
    std::uint64_t most_;  ///< photons of a part
    Checkpoint checkpoint_;

    // Of the part at hand.
    std::size_t part_ = 0;
    std::uint64_t done_ = 0;
    double spent_ = 0;  ///< s, by earlier runs
    Stopwatch since_;

    // Of all parts that are finished.
    std::vector<Fraction> values_;
    std::uint64_t photons_ = 0;
    double kernel_seconds_ = 0, unfinished_ = 0, beyond_ = 0;
};

}  // namespace

std::vector<LightSource> lights_of(const Job& job)
{
    if (!job.layers->quantity->on_grid()) return {job.layers->light};
    std::vector<LightSource> lights;
    for (const double degrees : job.header.axes.front().values)
        lights.push_back({.incidence = degrees * std::numbers::pi / 180});
    return lights;
}

SimulatedValues simulate(const Device& device, const Job& job,
                         const std::function<void(const LightProgress&)>& after_launch)
{
    return Simulation(device, job, after_launch).run();
}

void forget_simulation(const Job& job)
{
    Checkpoint(job.path, {}).remove();
}

}  // namespace gonio
