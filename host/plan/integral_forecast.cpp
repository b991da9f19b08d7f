// SPDX-License-Identifier: Apache-2.0
// What tables of integrals will cost: some of their materials, and of those some of their cells.
#include <algorithm>

#include "plan/forecast_parts.hpp"
#include "quadrature/derived.hpp"
#include "stopwatch.hpp"

namespace gonio {
namespace {

/// `count` of `all` numbers from 0 on, evenly; all of them if they are fewer.
std::vector<std::size_t> spread(std::size_t all, std::size_t count)
{
    count = std::min(all, count);
    std::vector<std::size_t> chosen;
    for (std::size_t k = 0; k < count; ++k) chosen.push_back((2 * k + 1) * all / (2 * count));
    return chosen;
}

/// The job of some materials; `cells` of their cells at most.
Job part_of(const Job& job, std::size_t materials, std::size_t cells)
{
    Job part = job;
    part.materials.clear();
    std::vector<IntegralCell> theirs;
    for (const std::size_t which : spread(job.materials.size(), materials)) {
        for (IntegralCell cell : job.cells) {
            if (cell.material != which) continue;
            cell.material = part.materials.size();
            theirs.push_back(cell);
        }
        part.materials.push_back(job.materials[which]);
    }
    part.cells.clear();
    for (const std::size_t which : spread(theirs.size(), cells))
        part.cells.push_back(theirs[which]);
    return part;
}

}  // namespace

Forecast integral_forecast(const Device& device, const Job& job)
{
    constexpr std::size_t materials = 16, cells = 256;
    // Cells of that quantity share their directions: fewer are not less work.
    Job part = part_of(job, materials, job.header.quantity == "kulla_conty" ? SIZE_MAX : cells);
    const double times =
        static_cast<double>(job.cells.size()) / static_cast<double>(part.cells.size());
    if (job.seconds) *part.seconds /= times;
    derive(device, part);  // builds the programs
    const Stopwatch since;
    const double reached = derive(device, part).largest_error;
    return {.seconds = times * since.seconds(),
            .error = std::max(reached, job.max_error),
            .error_of = integral_error_of,
            .is_bound = reached <= job.max_error};
}

}  // namespace gonio
