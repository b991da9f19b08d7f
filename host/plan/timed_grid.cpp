// SPDX-License-Identifier: Apache-2.0
// Grids as fine as a time allows.
#include "plan/timed_grid.hpp"

#include <algorithm>
#include <filesystem>

#include "compute/make_table.hpp"
#include "gonio/errors.hpp"
#include "plan/batch.hpp"
#include "plan/fitted_grid.hpp"
#include "plan/grid_header.hpp"
#include "plan/interrupt.hpp"
#include "stopwatch.hpp"

namespace gonio {
namespace {

constexpr double shape_error = 0.1;  // of the fit that tells how fine angles are by each other
constexpr double first_cells =
    0x1p14;                   // of the smallest table that is made to see how long it takes
constexpr double part = 0.8;  // of the time is planned with
constexpr double pilot_part =
    1.0 / 16;  // of it, at most, for tables that are only made to be timed

/// The grid of a table that is there already, if nothing else of it differs.
void keep_earlier_grid(Job& job)
{
    if (!job.fit || !std::filesystem::is_regular_file(job.path)) return;
    Job earlier = job;
    try {
        const TableHeader header = read_header(job.path);
        const auto* error = header.find("interpolation.error");
        if (error == nullptr || header.axes.size() != job.header.axes.size()) return;
        Counts counts;
        for (auto axis = header.axes.end() - std::ssize(job.grid.axes); axis != header.axes.end();
             ++axis)
            counts.push_back(axis->values.size());
        set_grid(earlier, grid_of(*job.fit, counts), std::get<double>(*error));
    } catch (const RunError&) {
        return;
    } catch (const UsageError&) {
        return;
    }
    if (!is_finished(earlier)) return;
    job = earlier;
    job.fit.reset();
}

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

    double seconds(const Device& device, const Grid& grid, const ComputeOptions& options)
    {
        set_grid(job_, grid, 1);
        const Stopwatch since;
        make_table(
            device, job_, [](std::size_t) { throw_if_interrupted(); }, options);
        return since.seconds();
    }

private:
    Job job_;
};

/// Tables grow until one takes a good part of the time: what it takes for itself counts less then.
double cells_in_time(const Device& device, const Job& job, const Counts& shape,
                     const ComputeOptions& options)
{
    Pilot pilot(job);
    pilot.seconds(device, coarsest_grid(*job.fit), options);  // builds the program
    const double time = part * *job.seconds;
    for (double cells = first_cells;;) {
        const Counts counts = scaled(shape, cells);
        const double took = pilot.seconds(device, grid_of(*job.fit, counts), options);
        const double fitting = cells_of(counts) * time / took;
        if (took > pilot_part * time || fitting >= most_cells) return std::min(fitting, most_cells);
        cells = std::max(2 * cells, fitting * pilot_part);
    }
}

void fit_to_time(const Device& device, Job& job, const ComputeOptions& options)
{
    const GridFitter fitter(job, *job.fit);
    const Counts shape = fitter.fit(shape_error).counts;
    const double cells = cells_in_time(device, job, shape, options);
    if (job.max_error > 0) {
        const FittedCounts exact = fitter.fit(job.max_error);
        if (cells_of(exact.counts) <= cells)
            return set_grid(job, grid_of(*job.fit, exact.counts), exact.error);
    }
    const Counts counts = scaled(shape, cells);
    set_grid(job, grid_of(*job.fit, counts), fitter.error(counts));
}

}  // namespace

void keep_earlier_grids(std::vector<Job>& jobs)
{
    for (Job& job : jobs) keep_earlier_grid(job);
}

void fit_to_time(const Device& device, std::vector<Job>& jobs, const ComputeOptions& options)
{
    catch_interrupts();
    if (options.leave_out) keep_earlier_grids(jobs);
    for (Job& job : jobs)
        if (job.fit) fit_to_time(device, job, options);
}

}  // namespace gonio
