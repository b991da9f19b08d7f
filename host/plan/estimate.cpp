// SPDX-License-Identifier: Apache-2.0
// How large the tables of jobs will be, and whether there is room for them.
#include "plan/estimate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <system_error>

#include "gonio/compute.hpp"
#include "gonio/errors.hpp"
#include "output/check.hpp"

namespace gonio {
namespace {

constexpr std::uint64_t csv_number = 12;      // characters that a number takes, about
constexpr std::uint64_t merl_value = 8;       // double
constexpr std::uint64_t tiles_in_memory = 2;  // one is computed while one is written

std::uint64_t file_bytes(const Job& job, std::uint64_t values)
{
    if (stores_half(job)) return values * 2;
    if (job.format == "merl") return values * merl_value;
    if (job.format != "csv") return values * sizeof(float);
    const auto cells = values / job.header.channels.size();
    return cells * (job.header.axes.size() + job.header.channels.size()) * csv_number;
}

std::string line(std::string_view what, std::string_view shape, const TableSize& size,
                 double seconds)
{
    return fmt::format("{:<40} {:<32} {:>10} on disk {:>10} in memory {:>10}\n", what, shape,
                       size_text(static_cast<double>(size.file_bytes)),
                       size_text(static_cast<double>(size.memory_bytes)), time_text(seconds));
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

TableSize size_of(const Job& job)
{
    TableSize size;
    size.values = job.header.cells() * job.header.channels.size();
    size.file_bytes = file_bytes(job, size.values);
    size.memory_bytes = std::min<std::uint64_t>(size.values * sizeof(float),
                                                tiles_in_memory * ComputeOptions{}.tile_bytes);
    return size;
}

std::string interpolation_text(const Job& job)
{
    if (job.header.find("interpolation.error") == nullptr || job.fit) return {};
    return fmt::format("interpolation is off by {:.2g} of the largest value, {} asked",
                       job.interpolation_error,
                       job.max_error > 0 ? fmt::format("{:.2g} is", job.max_error)
                                         : fmt::format("{} s are", *job.seconds));
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
    if (seconds == 0) return "0 s";
    if (seconds < 0.1) return "below 0.1 s";
    if (seconds < 10) return fmt::format("{:.1f} s", seconds);
    if (seconds < 120) return fmt::format("{:.0f} s", seconds);
    if (seconds < 7200) return fmt::format("{:.0f} min", seconds / 60);
    return fmt::format("{:.0f} h", seconds / 3600);
}

std::string estimate_text(const std::vector<Job>& jobs, const std::vector<Forecast>& forecasts)
{
    std::string text;
    TableSize sum;
    double seconds = 0;
    for (std::size_t k = 0; k < jobs.size(); ++k) {
        const Job& job = jobs[k];
        seconds += forecasts[k].seconds;
        if (job.fit) {
            text += fmt::format("{:<40} as many cells as {} s are enough for\n", job.path.string(),
                                *job.seconds);
            continue;
        }
        const TableSize size = size_of(job);
        sum.file_bytes += size.file_bytes;
        sum.memory_bytes = std::max(sum.memory_bytes, size.memory_bytes);
        const auto& channels = job.header.channels;
        const auto shape =
            fmt::format("{} x {}", shape_text(job.header),
                        channels.size() <= 4 ? fmt::format("{}", fmt::join(channels, ","))
                                             : fmt::format("{} channels", channels.size()));
        text += line(job.path.string(), shape, size, forecasts[k].seconds);
    }
    return text + line(fmt::format("{} tables", jobs.size()), "", sum, seconds);
}

void check_disk(const std::vector<Job>& jobs)
{
    std::map<std::filesystem::path, double> needed;
    for (const Job& job : jobs) {
        const auto directory = job.path.parent_path();
        double& bytes = needed[directory];
        bytes += static_cast<double>(size_of(job).file_bytes);
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
