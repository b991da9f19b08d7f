// SPDX-License-Identifier: Apache-2.0
// Makes the table of a job: computes, checks against the reference, writes.
#include "compute/make_table.hpp"

#include <fmt/format.h>

#include "gonio/errors.hpp"
#include "opencl/store_rate.hpp"
#include "quadrature/make_integrals.hpp"
#include "stopwatch.hpp"

namespace gonio {
namespace {

/// A poor man's share of what `gonio verify` does at length: a wrong driver must not fill tables.
void require_accuracy(const Device& device, const Job& job, const Accuracy& accuracy)
{
    const double bound = accuracy_bound(job.materials.front());
    if (accuracy.relative <= bound && accuracy.not_finite == 0) return;
    throw CheckFailed(fmt::format(
        "table `{}` on {} ({} {}): largest relative error {:.2g}, allowed is {:.2g}; expected "
        "{:.9g}, got {:.9g}; values that are not finite: {}",
        job.name, device.info().name, device.info().platform_name, device.info().driver,
        accuracy.relative, bound, accuracy.reference, accuracy.device, accuracy.not_finite));
}

void require_interpolation(const Job& job)
{
    if (!job.must_reach || job.interpolation_error <= job.max_error) return;
    throw RunError(fmt::format(
        "{}table `{}`: on {} cells{} interpolation is off by {:.2g} of the largest value, and not "
        "by at most the max_error of {:.2g}; --best-effort makes it so",
        job.where, job.name, job.header.cells() / job.materials.size(),
        job.seconds ? fmt::format(", as many as {} s are enough for,", *job.seconds) : "",
        job.interpolation_error, job.max_error));
}

}  // namespace

MadeTable make_table(const Device& device, const Job& job,
                     const std::function<void(std::size_t)>& after_rows,
                     const ComputeOptions& options)
{
    if (!job.cells.empty()) return make_integrals(device, job, after_rows);
    require_interpolation(job);
    MadeTable made;
    const std::unique_ptr<TableWriter> writer =
        make_writer(job.path, job.format, job.header, job.write);
    const std::size_t channels = job.header.channels.size();
    const std::size_t rows_per_point = job.header.rows() / job.materials.size();
    for (std::size_t point = 0; point < job.materials.size(); ++point) {
        const Material& material = job.materials[point];
        AccuracyCheck check(job.grid, channels);
        const auto write = [&](Rows<float> rows) {
            check.see(rows);
            rows.first += point * rows_per_point;
            writer->write(rows);
            after_rows(rows.count * job.header.row_length());
        };
        made.report = compute_grid(device, material, job.measure, job.grid, write, options);
        made.kernel_seconds += made.report.kernel_seconds;
        const Stopwatch checking;
        made.accuracy.merge(
            check.finish(make_reference(material, job.measure), direction_rounding(material)));
        made.checking_seconds += checking.seconds();
    }
    made.cells = job.header.cells();
    require_accuracy(device, job, made.accuracy);
    writer->finish();
    const double values_per_second =
        static_cast<double>(made.cells * channels) / made.kernel_seconds;
    made.store_fraction = values_per_second / stored_values_per_second(device);
    return made;
}

nlohmann::ordered_json run_information(const Device& device, const MadeTable& made)
{
    const DeviceInfo& info = device.info();
    if (made.integrals)
        return {{"device", info.name},
                {"platform", info.platform_name},
                {"driver", info.driver},
                {"width", made.report.width},
                {"cells", made.cells},
                {"order", made.integrals->order},
                {"evaluations", made.integrals->evaluated},
                {"kernel_seconds", made.kernel_seconds},
                {"largest_error", made.accuracy.relative},
                {"cells_checked", made.integrals->checked}};
    return {{"device", info.name},
            {"platform", info.platform_name},
            {"driver", info.driver},
            {"width", made.report.width},
            {"cells", made.cells},
            {"tiles", made.report.tiles},
            {"kernel_seconds", made.kernel_seconds},
            {"build_seconds", made.report.build_seconds},
            {"checking_seconds", made.checking_seconds},
            {"mirrored", made.report.mirrored},
            {"reciprocal", made.report.reciprocal},
            {"largest_relative_error", made.accuracy.relative},
            {"largest_absolute_error_of_maximum", made.accuracy.absolute},
            {"values_checked", made.accuracy.checked},
            {"all_values_checked", made.accuracy.complete}};
}

}  // namespace gonio
