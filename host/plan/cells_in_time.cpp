// SPDX-License-Identifier: Apache-2.0
// How many cells a time is enough for: tables are made until one takes a good part of it.
#include "plan/cells_in_time.hpp"

#include <algorithm>
#include <filesystem>

#include "compute/make_table.hpp"
#include "plan/grid_header.hpp"
#include "plan/interrupt.hpp"
#include "plan/table_cost.hpp"
#include "stopwatch.hpp"

namespace gonio {
namespace {

constexpr double first_cells = 0x1p14;        // of the first table that is larger than the coarsest
constexpr double aim = 0.25, enough = 0.125;  // parts of the time
constexpr double largest_step = 16;           // from one table's cells to the next one's

/// A file that is gone at the end.
class Pilot {
public:
    explicit Pilot(const Job& job) : job_(job)
    {
        std::filesystem::create_directories(job.path.parent_path());
        job_.path.replace_extension(".pilot" + job.path.extension().string());
        job_.must_reach = false;
    }
    ~Pilot()
    {
        std::error_code ignored;
        std::filesystem::remove(job_.path, ignored);
    }
    Pilot(const Pilot&) = delete;
    Pilot& operator=(const Pilot&) = delete;

    /// The faster of two tables: what else a machine does only adds.
    TableSeconds seconds(const Device& device, const Grid& grid, const ComputeOptions& options)
    {
        set_grid(job_, grid, 1);
        const TableSeconds first = once(device, options), second = once(device, options);
        return first.all < second.all ? first : second;
    }

private:
    TableSeconds once(const Device& device, const ComputeOptions& options) const
    {
        const Stopwatch since;
        const MadeTable made = make_table(
            device, job_, [](std::size_t) { throw_if_interrupted(); }, options);
        return {since.seconds(), made.checking_seconds};
    }

    Job job_;
};

}  // namespace

double cells_in_time(const Device& device, const Job& job, const Counts& shape, double most,
                     double time, const ComputeOptions& options)
{
    Pilot pilot(job);
    // The first one builds the program.
    const double small = pilot.seconds(device, coarsest_grid(*job.fit), options).all;
    const auto channels = double(job.header.channels.size());
    for (double cells = std::min(first_cells, most);;) {
        const Counts counts = scaled(shape, cells);
        const TableSeconds taken = pilot.seconds(device, grid_of(*job.fit, counts), options);
        const TableCost cost(small, taken, cells_of(counts), channels);
        if (taken.all > enough * time || cells >= most) return std::min(cost.cells_in(time), most);
        const double next = cost.cells_in(aim * time);
        cells = std::min(std::clamp(next, 2 * cells, largest_step * cells), most);
    }
}

}  // namespace gonio
