// SPDX-License-Identifier: Apache-2.0
// What tables of light that spreads in skin will cost: one of their sets, with few photons.
#include <algorithm>
#include <cmath>

#include "photon/bins.hpp"
#include "plan/forecast_parts.hpp"
#include "plan/trial.hpp"
#include "skin/profile_table.hpp"
#include "skin/skin_sets.hpp"

namespace gonio {
namespace {

class Pilot {
public:
    Pilot(const Device& device, const Job& job) : device_(device), job_(job)
    {
        job_.path = scratch_.path() / job.path.filename();
        job_.must_reach = false;
        if (job_.profile->seconds) job_.profile->seconds = INFINITY;  // batches as in time
        for (std::size_t k = 0; k < job_.skin->ladders.size(); ++k) {
            auto& values = job_.skin->ladders[k].values;
            values = {values[values.size() / 2]};
            job_.header.axes[k].values = values;
        }
    }

    /// The seconds that so many photons a base take, or as many as the errors need.
    double seconds(std::uint64_t photons)
    {
        job_.profile->photons = photons;
        const Stopwatch since;
        run_ = make_profile_table(device_, job_, [](double) {});
        return since.seconds();
    }

    double largest_error() const { return std::ranges::max(errors()); }
    std::string error_of() const { return run_["error_of"]; }

    /// As many photons, on the average: wavelengths have photons of their own.
    double times_needed(double error) const
    {
        const std::vector<double> all = errors();
        double sum = 0;
        for (const double found : all) sum += std::pow(found / error, 2);
        return std::max(1.0, sum / static_cast<double>(all.size()));
    }

private:
    /// Those of the wavelengths, or of the whole table.
    std::vector<double> errors() const
    {
        if (job_.header.quantity == "reflectance_r")
            return run_["spectra"][0]
                       [job_.profile->ring_error ? "ring_error" : "error_of_largest_value"];
        return {run_["error"].get<double>()};
    }

    const Device& device_;
    ScratchFolder scratch_;
    Job job_;
    nlohmann::ordered_json run_;
};

}  // namespace

Forecast profile_forecast(const Device& device, const Job& job)
{
    const ProfileRequest& wanted = *job.profile;
    const std::optional<double> asked = asked_error(job);
    // Errors that end the work take batches of 1024 photons, and some of these.
    std::uint64_t followed =
        std::min(wanted.photons, std::uint64_t{asked ? 1024 * least_batches : 1 << 13});
    const std::uint64_t few = followed / 8;
    Pilot pilot(device, job);
    pilot.seconds(few);  // builds the programs
    const double before = pilot.seconds(few);
    double seconds = pilot.seconds(followed), error = pilot.largest_error();
    // Rings that nothing has come to yet.
    while (std::isinf(error) && seconds < trial_seconds && followed <= wanted.photons / 4) {
        seconds = pilot.seconds(followed *= 4);
        error = pilot.largest_error();
    }
    const auto many = static_cast<double>(followed);
    // Of those photons, without what a run takes besides.
    const double of_all =
        std::max(seconds - before, 0.0) * many / (many - static_cast<double>(few));

    // As many photons.
    double times = static_cast<double>(wanted.photons) / many;
    if (wanted.seconds)
        times = std::min(times, std::max(1.0, 1 + (*wanted.seconds - seconds) / of_all));
    const double needed = asked ? pilot.times_needed(*asked) : INFINITY;
    Forecast result{.is_bound = needed <= times};
    times = std::min(times, needed);
    result.photons = times * many;
    result.seconds =
        (seconds + of_all * (times - 1)) * static_cast<double>(sets_of(*job.skin).size());
    result.error = result.is_bound ? *asked : error / std::sqrt(times);
    result.error_of = pilot.error_of();
    if (job.header.quantity == "preintegrated_rgb") result.error = error;  // not of noise alone
    if (!std::isinf(error)) return result;
    return {.seconds = wanted.seconds ? result.seconds : NAN};
}

}  // namespace gonio
