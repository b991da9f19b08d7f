// SPDX-License-Identifier: Apache-2.0
// Runs jobs as `run` and `table` do: with progress, and a summary of what was made.
#include "commands/batch_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compute/make_table.hpp"
#include "output/half_rounding.hpp"
#include "photon/light_table.hpp"
#include "plan/batch.hpp"
#include "plan/estimate.hpp"
#include "plan/interrupt.hpp"
#include "plan/progress.hpp"
#include "skin/profile_table.hpp"
#include "skin/skin_table.hpp"

namespace gonio {
namespace {

/// "ward + lambert"
std::string models_text(const Job& job)
{
    std::string text;
    for (const Lobe& lobe : job.materials.front().lobes)
        text += (text.empty() ? "" : " + ") + std::string(lobe.model->id);
    return text;
}

void print(const Job& job, const MadeTable& made, std::size_t width)
{
    const std::size_t evaluated = made.integrals ? made.integrals->evaluated : made.cells;
    const std::string store = made.integrals ? "" : fmt::format("{:.2f}", made.store_fraction);
    fmt::print("{:<{}} {:>11} {:>8.2f} {:>8} {:>9.1e}{} {}\n", models_text(job), width, made.cells,
               static_cast<double>(evaluated) / made.kernel_seconds * 1e-9, store,
               made.accuracy.relative, made.accuracy.complete ? ' ' : '*', job.path.string());
}

/// "error 1.2e-03 of the largest value, 2.0e-03 allowed"
std::string error_text(const Job& job, double error, std::string_view of)
{
    if (std::isinf(error)) return "no light has come";
    const auto asked = asked_error(job);
    return fmt::format("error {:.1e} of {}{}", error, of,
                       asked ? fmt::format(", {:.1e} allowed", *asked) : "");
}

/// Of skin.
std::string error_text(const Job& job, const nlohmann::ordered_json& run)
{
    return error_text(job, run.at("error").get<double>(), run.at("error_of").get<std::string>());
}

/// Tells progress of a job by the part that is done, and heeds Ctrl-C.
class Advance {
public:
    Advance(Progress& progress, const Job& job)
        : progress_(progress), cells_(static_cast<double>(job.header.cells()))
    {
    }
    ~Advance() { progress_.advance(cells_ * (1 - told_)); }
    Advance(const Advance&) = delete;
    Advance& operator=(const Advance&) = delete;

    void operator()(double part)
    {
        progress_.advance(cells_ * std::max(0.0, part - told_));
        told_ = std::max(told_, part);
        throw_if_interrupted();
    }

private:
    Progress& progress_;
    double cells_, told_ = 0;
};

/// Makes the table of layers with a line of progress; returns the line of the summary.
std::pair<std::string, nlohmann::ordered_json> make_layers(const Device& device, const Job& job,
                                                           Progress& progress, bool leave_out)
{
    Advance advance(progress, job);
    const auto after_launch = [&](const LightProgress& now) {
        if (now.photons_per_second > 0)
            progress.begin(fmt::format("{}, {:.2g} photons/s, error {:.1e}", job.name,
                                       now.photons_per_second, now.error));
        advance(now.fraction);
    };
    const LightTable made = make_light_table(device, job, after_launch, leave_out);
    const auto how = made.photons == 0 ? std::string("without noise")
                                       : fmt::format("{} photons, {:.3g} photons/s", made.photons,
                                                     made.photons_per_second);
    return {fmt::format("{}: solver {}, {}, {}, {}\n", job.name, job.layers->solver, how,
                        error_text(job, made.error, made.error_of), job.path.string()),
            made.run};
}

}  // namespace

void run_jobs(const Device& device, const std::vector<Job>& jobs, bool leave_out)
{
    catch_interrupts();
    fmt::print("on {} ({}, driver {}, width {})\n", device.info().name, device.info().platform_name,
               device.info().driver, device.width());
    std::vector<std::pair<Job, MadeTable>> made;
    std::string of_layers;
    const auto make = [&](const Job& job, Progress& progress) {
        if (job.profile) {
            Advance advance(progress, job);
            auto run = make_profile_table(device, job, [&](double part) { advance(part); });
            of_layers += fmt::format("{}: {} of skin, {:.3g} photons a wavelength, {}, {}\n",
                                     job.name, job.header.quantity, run.at("photons").get<double>(),
                                     error_text(job, run), job.path.string());
            return run;
        }
        if (job.skin) {
            Advance advance(progress, job);
            auto run = make_skin_table(job, [&](double part) { advance(part); });
            of_layers += fmt::format("{}: {} of skin, without noise, {}, {}\n", job.name,
                                     job.header.quantity, error_text(job, run), job.path.string());
            return run;
        }
        if (job.layers) {
            const auto [line, run] = make_layers(device, job, progress, leave_out);
            of_layers += line;
            return run;
        }
        const double channels = static_cast<double>(job.header.channels.size());
        const auto after_rows = [&](std::size_t cells) {
            progress.advance(channels * static_cast<double>(cells));
            throw_if_interrupted();
        };
        made.emplace_back(job, make_table(device, job, after_rows, {.leave_out = leave_out}));
        return run_information(device, made.back().second);
    };
    bool rounded = false;
    const auto make_and_round = [&](const Job& job, Progress& progress) {
        nlohmann::ordered_json run = make(job, progress);
        if (!stores_half(job)) return run;
        rounded = true;
        run["rounding_to_half"] = {{"relative", half_rounding::relative},
                                   {"absolute", half_rounding::absolute},
                                   {"absolute_below", half_rounding::least_normal}};
        return run;
    };
    const BatchReport report =
        run_batch(jobs, make_and_round, leave_out ? Keep::finished : Keep::nothing);
    std::size_t width = 0;
    for (const auto& [job, table] : made) width = std::max(width, models_text(job).size());
    if (!made.empty())
        fmt::print("{:<{}} {:>11} {:>8} {:>8} {:>9}  {}\n", "model", width, "cells", "Geval/s",
                   "of store", "error", "file");
    for (const auto& [job, table] : made) print(job, table, width);
    if (std::ranges::any_of(made,
                            [](const auto& entry) { return !entry.second.accuracy.complete; }))
        fmt::print("* checked on 250 000 stratified cells and the extremes\n");
    for (const auto& [job, table] : made) {
        if (const std::string text = interpolation_text(job); !text.empty())
            fmt::print("{}: {}\n", job.name, text);
        if (table.integrals && job.must_reach)
            fmt::print("{}: {}\n", job.name,
                       error_text(job, table.accuracy.relative, integral_error_of));
    }
    fmt::print("{}", of_layers);
    if (rounded)
        fmt::print(
            "half precision adds up to {:.1e} of a value to these errors, {:.1e} below {:.1e}\n",
            half_rounding::relative, half_rounding::absolute, half_rounding::least_normal);
    fmt::print("{} made, {}{} already finished\n", report.made,
               report.copied == 0 ? "" : fmt::format("{} copied, ", report.copied), report.kept);
}

void print_estimate(const Device& device, const std::vector<Job>& jobs)
{
    fmt::print("{}", estimate_text(jobs, forecasts(device, jobs)));
}

}  // namespace gonio
