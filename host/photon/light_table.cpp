// SPDX-License-Identifier: Apache-2.0
// Makes the table of a job with layers: by adding-doubling, or by Monte Carlo until a budget ends.
#include "photon/light_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gonio/errors.hpp"
#include "photon/asked_layers.hpp"
#include "photon/bins.hpp"
#include "photon/exact_values.hpp"
#include "photon/simulation.hpp"
#include "scene/located.hpp"

namespace gonio {
namespace {

/// A number has a channel for each of its parts and then one for the error of each.
void write(const Job& job, const std::vector<Fraction>& values)
{
    Table table{job.header, {}};
    if (job.header.axes.empty()) {
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

}  // namespace

LightTable make_light_table(const Device& device, const Job& given,
                            const std::function<void(const LightProgress&)>& after_launch,
                            bool leave_out)
{
    Job job = given;
    if (leave_out) job.layers->medium = asked_layers(given).medium;
    return located(job.where, [&]() -> LightTable {
        if (job.layers->solver == "monte_carlo") {
            const SimulatedValues simulated = simulate(device, job, after_launch);
            write(job, simulated.values);
            forget_simulation(job);
            return simulated.table;
        }
        const ExactValues exact = exact_values(
            *job.layers, job.header.axes, [&](double part) { after_launch({.fraction = part}); });
        const Budget& budget = job.layers->budget;
        if (job.must_reach && exact.error > *budget.max_error)
            throw RunError(fmt::format(
                "with {} nodes, as many as {} s are enough for, table `{}` is off by {:.2g}, and "
                "not by {:.2g}; give it more, or --best-effort",
                exact.nodes, *budget.seconds, job.name, exact.error, *budget.max_error));
        write(job, exact.values);
        const char* of = error_of(*job.layers);
        return {0,
                0,
                exact.error,
                of,
                {{"nodes", exact.nodes}, {"error", exact.error}, {"error_of", of}}};
    });
}

}  // namespace gonio
