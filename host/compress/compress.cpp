// SPDX-License-Identifier: Apache-2.0
// Residuals of tables, folded and rounded.
#include "compress/compress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "compress/fit.hpp"
#include "gonio/errors.hpp"
#include "gonio/grid.hpp"
#include "gonio/residual.hpp"

namespace gonio {
namespace {

constexpr double floor_of_relative = 1e-6;
constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// To a multiple of the greatest power of two that moves it by at most `error`.
double rounded(double value, double error)
{
    if (!(error > 0)) return value;
    const double step = std::exp2(std::floor(std::log2(2 * error)));
    return std::nearbyint(value / step) * step;
}

/// The axes up to 90 degrees of phi_d, or all of them if no cell ends there.
std::size_t kept_azimuths(const Axis& phi)
{
    const std::size_t count = phi.values.size();
    const bool at_ninety = (count % 2 == 0) == (phi.samples == Samples::centre);
    const bool whole = phi.values.back() > 100;
    return at_ninety && whole ? (count + 1) / 2 : count;
}

TableHeader header_of(const Table& table, const Lobe& lobe)
{
    TableHeader header = table.header;
    header.quantity = residual_quantity;
    header.unit = "1";
    header.axes[2].values.resize(kept_azimuths(header.axes[2]));
    header.single_precision = true;
    header.attributes = {{"title", "log(f / lobe): lobe is model lebedev without a residual"}};
    for (std::size_t k = 0; k < lobe.values.size(); ++k)
        if (lobe.model->parameters[k].kind != Kind::table)
            header.attributes.emplace_back(fmt::format("lobe.{}", lobe.model->parameters[k].name),
                                           lobe.values[k]);
    for (const auto& [name, value] : table.header.attributes)
        header.attributes.emplace_back("table." + name, value);
    return header;
}

}  // namespace

Table compress(const Table& table, const std::string& name, double error)
{
    if (table.header.quantity != "brdf")
        throw UsageError(
            fmt::format("{}: holds `{}`; only `brdf` is compressed", name, table.header.quantity));
    residual_of(table, name);  // throws if model lebedev could not read it
    const Lobe lobe = fit_lobe(table);
    const Reference analytic = make_reference({"", {lobe}}, Measure::brdf);
    Table residual{header_of(table, lobe), {}};
    const GridVectors vectors({GridKind::rusinkiewicz, table.header.axes});
    const std::size_t length = table.header.row_length(), kept = residual.header.row_length();
    for (std::size_t c = 0; c < table.values.size(); ++c) {
        const auto value = [&](std::size_t cell) { return std::max(table.values[c][cell], 0.0); };
        std::vector<double>& to = residual.values.emplace_back(residual.header.cells(), missing);
        for (std::size_t k = 0; k < to.size(); ++k) {
            const std::size_t first = k / kept * length, column = k % kept;
            const auto [l, v] = vectors.at(k / kept, column);
            if (!(l.z > 0) || !(v.z > 0)) continue;
            const double here = value(first + column),
                         mirrored = value(first + length - 1 - column);
            const double f = kept == length ? here : (here + mirrored) / 2;
            to[k] = rounded(std::log(f / analytic(l, v, c)), error);
        }
    }
    return residual;
}

Loss loss_of(const Lobe& lobe, const Table& table)
{
    const Reference f = make_reference({"", {lobe}}, Measure::brdf);
    const GridVectors vectors({GridKind::rusinkiewicz, table.header.axes});
    const std::size_t length = table.header.row_length();
    Loss loss;
    double maximum = 0, squares = 0, count = 0;
    for (const auto& plane : table.values)
        for (const double value : plane)
            if (std::isfinite(value)) maximum = std::max(maximum, value);
    for (std::size_t c = 0; c < table.values.size(); ++c)
        for (std::size_t k = 0; k < table.values[c].size(); ++k) {
            const auto [l, v] = vectors.at(k / length, k % length);
            const double expected = table.values[c][k];
            if (!(l.z > 0) || !(v.z > 0) || !std::isfinite(expected)) continue;
            const double error = std::abs(f(l, v, c) - expected);
            loss.largest_of_maximum = std::max(loss.largest_of_maximum, error / maximum);
            if (expected < floor_of_relative * maximum) continue;
            loss.largest = std::max(loss.largest, error / expected);
            squares += error / expected * (error / expected);
            ++count;
        }
    loss.rms = std::sqrt(squares / std::max(count, 1.0));
    return loss;
}

}  // namespace gonio
