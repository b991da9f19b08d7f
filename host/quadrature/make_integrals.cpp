// SPDX-License-Identifier: Apache-2.0
// Makes the table of a job of integrals: computes, checks against the reference, writes.
#include "quadrature/make_integrals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "gonio/errors.hpp"
#include "quadrature/derived.hpp"
#include "reference/albedo.hpp"

namespace gonio {
namespace {

constexpr double tolerance = 2e-6;  // of the reference

/// What the first channel, or for a split sum the albedo at f0 = 1, should be; empty for quantities
/// that are made of such albedos.
std::optional<double> expected(const Job& job, const IntegralCell& cell)
{
    const std::string& quantity = job.header.quantity;
    Material material = job.materials[cell.material];
    const bool split_sum = quantity.starts_with("dfg");
    if (split_sum)
        for (Lobe& lobe : material.lobes) lobe.set("f0", std::vector{1.0});
    const Reference f = make_reference(material, Measure::brdf);
    const glm::dvec3 at = unit_vector(cell.at);
    if (quantity == "directional_albedo") return reference::directional_albedo(f, at, 0, tolerance);
    if (split_sum || quantity == "hemispherical_directional_reflectance")
        return reference::hemispherical_directional(f, at, 0, tolerance);
    return {};
}

double computed(const Job& job, const DerivedTable& table, std::size_t cell)
{
    if (job.header.quantity == "dfg") return table.values[0][cell] + table.values[1][cell];
    if (job.header.quantity == "dfg_multiscatter") return table.values[1][cell];
    return table.values[0][cell];
}

/// The first cell, the middle one and the last: the two quadratures share no code.
std::size_t check_cells(const Device& device, const Job& job, const DerivedTable& table)
{
    std::size_t checked = 0;
    const std::size_t last = job.cells.size() - 1;
    for (const std::size_t cell : std::set{std::size_t{0}, last / 2, last}) {
        const auto right = expected(job, job.cells[cell]);
        if (!right) continue;
        ++checked;
        const double got = computed(job, table, cell);
        const double bound = table.largest_error + accuracy_bound(job.materials.front());
        if (std::abs(got - *right) <= bound * std::max(1.0, std::abs(*right))) continue;
        throw CheckFailed(fmt::format(
            "table `{}` on {} ({} {}): cell {} is {:.9g}; expected is {:.9g}, to {:.2g}", job.name,
            device.info().name, device.info().platform_name, device.info().driver, cell, got,
            *right, bound));
    }
    return checked;
}

void check_values(const Job& job, const DerivedTable& table)
{
    for (const auto& plane : table.values)
        for (const double value : plane)
            if (!std::isfinite(value))
                throw RunError(fmt::format("{}table `{}` has values that are not finite", job.where,
                                           job.name));
    if (job.must_reach && table.largest_error > job.max_error)
        throw RunError(fmt::format(
            "{}table `{}`: the largest error is {:.2g} at the highest order{}; asked for is {:.2g}",
            job.where, job.name, table.largest_error,
            job.seconds ? fmt::format(" for which {} s are enough", *job.seconds) : "",
            job.max_error));
}

}  // namespace

MadeTable make_integrals(const Device& device, const Job& job,
                         const std::function<void(std::size_t)>& after_rows)
{
    const std::unique_ptr<TableWriter> writer =
        make_writer(job.path, job.format, job.header, job.write);
    const DerivedTable table = derive(device, job);
    check_values(job, table);
    MadeTable made;
    made.integrals =
        IntegralReport{table.spent.order, table.spent.evaluated, check_cells(device, job, table)};
    std::vector<std::vector<float>> planes;
    Rows<float> rows{0, job.header.rows(), {}};
    for (const auto& plane : table.values) planes.emplace_back(plane.begin(), plane.end());
    for (const auto& plane : planes) rows.planes.push_back(plane.data());
    writer->write(rows);
    writer->finish();
    after_rows(job.cells.size());
    made.cells = job.cells.size();
    made.kernel_seconds = table.spent.kernel_seconds;
    made.report.width = device.width();
    made.accuracy.relative = table.largest_error;
    return made;
}

}  // namespace gonio
