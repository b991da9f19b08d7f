// SPDX-License-Identifier: Apache-2.0
// The list of sections, and how they measure.
#include "timings/sections.hpp"

#include <fmt/format.h>

#include "stopwatch.hpp"

namespace gonio {

Device BenchRun::at_width(unsigned width) const
{
    return Device(fmt::format("{}:{}", device.info().platform, device.info().device), width);
}

std::vector<Quartiles> interleaved(const std::vector<std::function<double()>>& runs, int rounds)
{
    std::vector<std::vector<double>> seconds(runs.size());
    for (int round = 0; round < rounds; ++round)
        for (std::size_t k = 0; k < runs.size(); ++k) seconds[k].push_back(runs[k]());
    std::vector<Quartiles> spreads;
    for (std::vector<double>& all : seconds) spreads.push_back(quartiles_of(std::move(all)));
    return spreads;
}

void time_in_turn(BenchPlot& plot, std::vector<Candidate> candidates, int rounds)
{
    std::vector<std::function<double()>> runs;
    for (const Candidate& candidate : candidates) runs.push_back(candidate.run);
    const std::vector<Quartiles> times = interleaved(runs, rounds);
    for (std::size_t k = 0; k < candidates.size(); ++k) {
        plot.points.push_back(std::move(candidates[k].point));
        plot.points.back().x = times[k];
    }
}

Quartiles rate_of(double amount, const Quartiles& seconds)
{
    return {amount / seconds.median, amount / seconds.high, amount / seconds.low};
}

double seconds_on_the_wall(const std::function<void()>& work)
{
    const Stopwatch since;
    work();
    return since.seconds();
}

const std::vector<BenchSection>& bench_sections()
{
    static const std::vector<BenchSection> all{
        {"models", "every model on a dense grid: error against time", bench_models},
        {"lookup", "evaluation against tables: error against time", bench_lookup},
        {"lookup-sharp", "the same of a sharp lobe", bench_lookup_sharp},
        {"lookup-diffuse", "the same of a diffuse lobe", bench_lookup_diffuse},
        {"split-sum", "quadrature against sampling: error against time", bench_split_sum},
        {"photons", "photons and adding-doubling: error against time", bench_photons},
        {"tallies", "photons by angle, depth, distance, time: error against time", bench_tallies},
        {"time-to-error", "seconds to an asked error", bench_time_to_error},
        {"generators", "random numbers: speed and bias", bench_generators},
        {"generator-errors", "random numbers: error against photons", bench_generator_errors},
        {"device-generators", "the same on the device", bench_device_generators},
        {"choices", "vector width, roulette, absorption: what they gain", bench_photon_choices},
        {"scaling", "over compute units", bench_scaling},
        {"work-size", "over the size of a launch", bench_work_size},
        {"tiles", "over sizes of tiles", bench_tiles},
        {"start", "building programs and first launches", bench_start},
        {"savings", "scenes with their plan and without", bench_savings},
    };
    return all;
}

}  // namespace gonio
