// SPDX-License-Identifier: Apache-2.0
// Grids as fine as a time allows.
#include "plan/timed_grid.hpp"

#include <filesystem>

#include "gonio/errors.hpp"
#include "plan/batch.hpp"
#include "plan/cells_in_time.hpp"
#include "plan/fitted_grid.hpp"
#include "plan/grid_header.hpp"
#include "plan/interrupt.hpp"

namespace gonio {
namespace {

constexpr double shape_error = 0.1;  // of the fit that tells how fine angles are by each other
constexpr double part = 0.8;         // of the time is planned with

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

void fit_to_time(const Device& device, Job& job, const ComputeOptions& options)
{
    const GridFitter fitter(job, *job.fit);
    const Counts shape = fitter.fit(shape_error).counts;
    const FittedCounts exact = job.max_error > 0 ? fitter.fit(job.max_error) : FittedCounts{};
    const double most = exact.counts.empty() ? most_cells : cells_of(exact.counts);
    const double cells = cells_in_time(device, job, shape, most, part * *job.seconds, options);
    if (cells >= most && !exact.counts.empty())
        return set_grid(job, grid_of(*job.fit, exact.counts), exact.error);
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
