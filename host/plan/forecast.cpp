// SPDX-License-Identifier: Apache-2.0
// Each job by a part of it, or by the beginning of all of it.
#include "plan/forecast.hpp"

#include <algorithm>

#include "photon/asked_layers.hpp"
#include "photon/exact_values.hpp"
#include "picture/picture_material.hpp"
#include "plan/batch.hpp"
#include "plan/forecast_parts.hpp"
#include "plan/trial.hpp"
#include "scene/located.hpp"
#include "skin/skin_table.hpp"

namespace gonio {
namespace {

Forecast skin_forecast(const Job& job)
{
    const ScratchFolder scratch;
    Job pilot = job;
    pilot.path = scratch.path() / job.path.filename();
    const double seconds =
        seconds_by_trial([&](const auto& after_part) { make_skin_table(pilot, after_part); });
    return {.seconds = seconds, .error = job.skin->tolerance, .error_of = "the light"};
}

}  // namespace

Forecast exact_forecast(const Job& job)
{
    LightJob light = *job.layers;
    light.medium = asked_layers(job).medium;
    Forecast result{.error = tolerance_of(light), .error_of = error_of(light)};
    if (!light.budget.seconds) {
        // How many nodes it needs is seen when two solutions are compared.
        constexpr double two_solutions = 1;
        double reached = NAN;  // unless that is all there is to do
        const auto solve = [&](const auto& after_part) {
            reached = exact_values(light, job.header.axes, after_part).error;
        };
        result.seconds = seconds_by_trial(solve, two_solutions);
        result.is_bound = result.error > 0;
        if (!result.is_bound) result.error = reached;
        return result;
    }
    // As many nodes as the time is enough for: the work grows with their cube, and the error falls
    // exponentially.
    const double all = *light.budget.seconds;
    light.budget.seconds = std::min(all, trial_seconds);
    const Stopwatch since;
    const double reached = std::min(exact_values(light, job.header.axes).error, 0.9);
    const double took = since.seconds();
    result.seconds = took;
    if (reached <= result.error) return result;
    const double wanted = result.error > 0 ? std::log(result.error) / std::log(reached) : INFINITY;
    const double fitting = std::max(1.0, std::cbrt(all / took));
    result.seconds = std::min(all, took * std::pow(wanted, 3));
    result.is_bound = wanted <= fitting;
    constexpr double rounding = 1e-12;
    if (!result.is_bound) result.error = std::max(std::pow(reached, fitting), rounding);
    return result;
}

std::optional<double> asked_error(const Job& job)
{
    if (job.profile)
        return job.profile->ring_error ? job.profile->ring_error : job.profile->max_error;
    if (job.skin) return job.skin->tolerance;
    if (job.layers) return job.layers->budget.max_error;
    return job.must_reach ? std::optional(job.max_error) : std::nullopt;
}

Forecast forecast(const Device& device, const Job& job)
{
    return located(job.where, [&] {
        if (job.profile) return profile_forecast(device, job);
        if (job.skin) return skin_forecast(job);
        if (!job.layers)
            return job.cells.empty() ? grid_forecast(device, job) : integral_forecast(device, job);
        return job.layers->solver == "monte_carlo" ? photon_forecast(device, job)
                                                   : exact_forecast(job);
    });
}

double picture_seconds(const Device& device, const PictureRequest& picture,
                       const std::vector<SceneMaterial>& materials)
{
    constexpr double several_parts = 1;
    const double all = work_of(picture, materials);
    double done = 0;
    return seconds_by_trial(
        [&](const auto& after_part) {
            make_picture(device, picture, materials, [&](std::string_view, double amount) {
                if (amount > 0) after_part((done += amount) / all);
            });
        },
        several_parts);
}

std::vector<Forecast> forecasts(const Device& device, const std::vector<Job>& jobs)
{
    const std::vector<const Job*> twins = equal_jobs(jobs);
    std::vector<Forecast> all;
    for (std::size_t k = 0; k < jobs.size(); ++k)
        all.push_back(twins[k] != nullptr || is_finished(jobs[k]) ? Forecast{}
                                                                  : forecast(device, jobs[k]));
    return all;
}

}  // namespace gonio
