// SPDX-License-Identifier: Apache-2.0
// What is benchmarked, one file a section.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "gonio/device.hpp"
#include "timings/report.hpp"

namespace gonio {

/// What sections know of the run they are part of.
struct BenchRun {
    Device device;
    bool quick = false;
    /// Says what comes next; throws Interrupted after Ctrl-C.
    std::function<void(const std::string&)> step;

    int rounds() const { return quick ? 3 : 7; }
    /// The same device at another vector width.
    Device at_width(unsigned width) const;
};

/// Calls each in turn, `rounds` times; each tells the seconds that it took.
std::vector<Quartiles> interleaved(const std::vector<std::function<double()>>& runs, int rounds);

/// A point, and what tells its x: the time that it takes.
struct Candidate {
    BenchPoint point;
    std::function<double()> run;
};

/// Runs them in turn, and adds their points to the plot.
void time_in_turn(BenchPlot& plot, std::vector<Candidate> candidates, int rounds);

/// Of so much work a second.
Quartiles rate_of(double amount, const Quartiles& seconds);

/// Of a clock on the wall.
double seconds_on_the_wall(const std::function<void()>& work);

BenchPlot bench_models(const BenchRun& run);
BenchPlot bench_lookup(const BenchRun& run);
BenchPlot bench_lookup_sharp(const BenchRun& run);
BenchPlot bench_lookup_diffuse(const BenchRun& run);
BenchPlot bench_split_sum(const BenchRun& run);
BenchPlot bench_photons(const BenchRun& run);
BenchPlot bench_tallies(const BenchRun& run);
BenchPlot bench_time_to_error(const BenchRun& run);
BenchPlot bench_generators(const BenchRun& run);
BenchPlot bench_generator_errors(const BenchRun& run);
BenchPlot bench_device_generators(const BenchRun& run);
BenchPlot bench_photon_choices(const BenchRun& run);
BenchPlot bench_scaling(const BenchRun& run);
BenchPlot bench_work_size(const BenchRun& run);
BenchPlot bench_tiles(const BenchRun& run);
BenchPlot bench_start(const BenchRun& run);
BenchPlot bench_savings(const BenchRun& run);

struct BenchSection {
    std::string_view name, what;
    BenchPlot (*run)(const BenchRun&);
};

/// In the order in which they run.
const std::vector<BenchSection>& bench_sections();

}  // namespace gonio
