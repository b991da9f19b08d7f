// SPDX-License-Identifier: Apache-2.0
// Sizes and times of jobs, and whether the disk has room for them.
#include "plan/estimate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <system_error>

#include "gonio/compute.hpp"
#include "gonio/errors.hpp"
#include "output/check.hpp"

namespace gonio {
namespace {

constexpr std::uint64_t csv_number = 12;  // characters that a number takes, about
constexpr std::uint64_t merl_value = 8;   // double
constexpr double evaluations_of_an_integral = 1000;
constexpr std::uint64_t tiles_in_memory = 2;  // one is computed while one is written

std::uint64_t file_bytes(const Job& job, std::uint64_t values)
{
    if (job.format == "exr" && job.write.half) return values * 2;
    if (job.format == "merl") return values * merl_value;
    if (job.format != "csv") return values * sizeof(float);
    const auto cells = values / job.header.channels.size();
    return cells * (job.header.axes.size() + job.header.channels.size()) * csv_number;
}

std::string size_text(double bytes)
{
    for (const auto unit : {"B", "KiB", "MiB", "GiB"}) {
        if (bytes < 1024) return fmt::format("{:.3g} {}", bytes, unit);
        bytes /= 1024;
    }
    return fmt::format("{:.3g} TiB", bytes);
}

std::string time_text(double seconds)
{
    if (std::isnan(seconds)) return "?";
    if (seconds < 1) return "below 1 s";
    if (seconds < 120) return fmt::format("{:.0f} s", seconds);
    return fmt::format("{:.0f} min", seconds / 60);
}

std::string line(std::string_view what, std::string_view shape, const Estimate& cost)
{
    return fmt::format("{:<40} {:<32} {:>10} on disk {:>10} in memory {:>10}\n", what, shape,
                       size_text(static_cast<double>(cost.file_bytes)),
                       size_text(static_cast<double>(cost.memory_bytes)), time_text(cost.seconds));
}

/// The folder itself, or the nearest above it that exists.
std::filesystem::path existing(std::filesystem::path directory)
{
    std::error_code ignored;
    directory = std::filesystem::absolute(directory, ignored);
    while (!std::filesystem::exists(directory, ignored) && directory != directory.root_path())
        directory = directory.parent_path();
    return directory;
}

}  // namespace

Estimate estimate(const Job& job, double values_per_second)
{
    Estimate cost;
    cost.values = job.header.cells() * job.header.channels.size();
    cost.file_bytes = file_bytes(job, cost.values);
    cost.memory_bytes = std::min<std::uint64_t>(cost.values * sizeof(float),
                                                tiles_in_memory * ComputeOptions{}.tile_bytes);
    // What a photon takes is known when some have been followed.
    cost.seconds = job.layers || job.skin ? std::numeric_limits<double>::quiet_NaN()
                                          : static_cast<double>(cost.values) / values_per_second;
    if (!job.cells.empty()) cost.seconds *= evaluations_of_an_integral;
    if (job.seconds) cost.seconds = *job.seconds;
    if (job.layers && job.layers->budget.seconds) cost.seconds = *job.layers->budget.seconds;
    return cost;
}

std::vector<Estimate> estimates(const std::vector<Job>& jobs, double values_per_second)
{
    std::vector<Estimate> costs;
    for (const Job& job : jobs) costs.push_back(estimate(job, values_per_second));
    return costs;
}

std::string estimate_text(const std::vector<Job>& jobs, const std::vector<Estimate>& costs)
{
    std::string text;
    Estimate sum;
    for (std::size_t k = 0; k < jobs.size(); ++k) {
        const Job& job = jobs[k];
        if (job.fit) {
            text += fmt::format("{:<40} as many cells as {} s are enough for\n", job.path.string(),
                                *job.seconds);
            continue;
        }
        const Estimate& cost = costs[k];
        sum.file_bytes += cost.file_bytes;
        sum.memory_bytes = std::max(sum.memory_bytes, cost.memory_bytes);
        sum.seconds += cost.seconds;
        const auto& channels = job.header.channels;
        const auto shape =
            fmt::format("{} x {}", shape_text(job.header),
                        channels.size() <= 4 ? fmt::format("{}", fmt::join(channels, ","))
                                             : fmt::format("{} channels", channels.size()));
        text += line(job.path.string(), shape, cost);
    }
    return text + line(fmt::format("{} tables", jobs.size()), "", sum);
}

void check_disk(const std::vector<Job>& jobs)
{
    std::map<std::filesystem::path, double> needed;
    for (const Job& job : jobs) {
        const auto directory = job.path.parent_path();
        double& bytes = needed[directory];
        bytes += static_cast<double>(estimate(job, 1).file_bytes);
        std::error_code unknown;
        const auto space = std::filesystem::space(existing(directory), unknown);
        if (unknown || bytes <= static_cast<double>(space.available)) continue;
        throw UsageError(
            fmt::format("{}with the table `{}` of {} cells the files in {} need {} before "
                        "compression, where {} "
                        "are free",
                        job.where, job.name, shape_text(job.header), directory.string(),
                        size_text(bytes), size_text(static_cast<double>(space.available))));
    }
}

}  // namespace gonio
