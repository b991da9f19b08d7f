// SPDX-License-Identifier: Apache-2.0
// Makes residual grids of tables: folds phi_d, goes on below the horizon, gives the poles one
// value.
#include "gonio/residual.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "gonio/errors.hpp"
#include "gonio/material.hpp"
#include "grid/rusinkiewicz.hpp"
#include "output/conventions.hpp"
#include "output/grid_coordinates.hpp"

namespace gonio {
namespace {

constexpr double radian = std::numbers::pi / 180;
constexpr double tolerance = 1e-6;                                // of a degree
constexpr double largest_range = 34.538776394910684;              // log 1e15
constexpr std::size_t most_values = (std::size_t{1} << 24) - 64;  // a kernel counts them in float32

bool is_near(double a, double b)
{
    return std::abs(a - b) < tolerance;
}

[[noreturn]] void refuse(const std::string& fault)
{
    throw UsageError(fmt::format(
        "{}; a residual is a table over theta_h, theta_d, phi_d as `gonio compress` writes it, "
        "or one of f: `gonio table --kind rusinkiewicz`, or a MERL .binary",
        fault));
}

[[noreturn]] void refuse(const std::string& name, const std::string& fault)
{
    refuse(fmt::format("{}: {}", name, fault));
}

/// Square roots of MERL's theta_h, which are even; else the axis as it is. Degrees, or their roots.
Axis coordinates(Axis axis, bool root)
{
    if (root)
        for (double& value : axis.values) value = std::sqrt(value);
    return axis;
}

/// Does the even axis begin at a node at 0, or in the middle of a cell that does?
bool begins_at_pole(const Axis& axis)
{
    if (axis.values.size() < 3 || !is_evenly_spaced(axis)) return false;
    const double first = axis.values[0], step = axis.values[1] - first;
    return step > 0 && is_near(first, axis.samples == Samples::node ? 0 : step / 2);
}

/// One channel of a table on its way to a grid: [theta_h][theta_d][phi_d].
struct Block {
    std::size_t h, d, phi;
    std::vector<double> values;

    double& at(std::size_t i, std::size_t j, std::size_t k)
    {
        return values[(i * d + j) * phi + k];
    }
    double mean(std::size_t i, std::size_t j)
    {
        double sum = 0;
        for (std::size_t k = 0; k < phi; ++k) sum += at(i, j, k);
        return sum / static_cast<double>(phi);
    }
};

/// The mean of phi_d and 180 - phi_d, up to 90 degrees.
Block folded(Block from)
{
    Block to{from.h, from.d, (from.phi + 1) / 2, {}};
    to.values.resize(to.h * to.d * to.phi);
    for (std::size_t i = 0; i < to.h; ++i)
        for (std::size_t j = 0; j < to.d; ++j)
            for (std::size_t k = 0; k < to.phi; ++k)
                to.at(i, j, k) = (from.at(i, j, k) + from.at(i, j, from.phi - 1 - k)) / 2;
    return to;
}

/// Below the horizon, and where values are missing before it, the last one above goes on.
void go_on_below_horizon(Block& block, const std::vector<Axis>& axes, const std::string& name)
{
    const auto &h = axes[0].values, &d = axes[1].values, &phi = axes[2].values;
    for (std::size_t i = 0; i < block.h; ++i)
        for (std::size_t k = 0; k < block.phi; ++k) {
            std::size_t count = block.d;  // of values above the horizon
            while (count > 0 && (is_below_horizon(h[i], d[count - 1], phi[k]) ||
                                 std::isnan(block.at(i, count - 1, k))))
                --count;
            for (std::size_t j = 0; j < count; ++j)
                if (!(block.at(i, j, k) < HUGE_VAL))
                    refuse(name, fmt::format("holds {} at theta_h {:.6g}, theta_d {:.6g}, phi_d "
                                             "{:.6g} deg, above the horizon",
                                             block.at(i, j, k), h[i], d[j], phi[k]));
            const double last = count > 0 ? block.at(i, count - 1, k)
                                : i > 0   ? block.at(i - 1, 0, k)
                                          : 0;
            for (std::size_t j = count; j < block.d; ++j) block.at(i, j, k) = last;
        }
}

/// Samples at the poles of theta_h and theta_d: added, or replaced by their mean over phi_d.
Block with_poles(Block from, bool add_h, bool add_d)
{
    Block to{from.h + (add_h ? 1 : 0), from.d + (add_d ? 1 : 0), from.phi, {}};
    to.values.resize(to.h * to.d * to.phi);
    for (std::size_t i = 0; i < to.h; ++i)
        for (std::size_t j = 0; j < to.d; ++j)
            for (std::size_t k = 0; k < to.phi; ++k) {
                const std::size_t h = add_h && i > 0 ? i - 1 : i, d = add_d && j > 0 ? j - 1 : j;
                to.at(i, j, k) = i == 0 || j == 0 ? from.mean(h, d) : from.at(h, d, k);
            }
    return to;
}

std::string digest_of(const std::vector<float>& values)
{
    std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a
    const auto* bytes = reinterpret_cast<const unsigned char*>(values.data());
    for (std::size_t k = 0; k < values.size() * sizeof(float); ++k)
        hash = (hash ^ bytes[k]) * 0x100000001b3;
    return fmt::format("{:016x}", hash);
}

/// The lobe that the residual belongs to: attributes lobe.*
decltype(ResidualGrid::parameters) lobe_of(const TableHeader& header)
{
    constexpr std::string_view prefix = "lobe.";
    decltype(ResidualGrid::parameters) all;
    for (const auto& [name, value] : header.attributes) {
        if (!name.starts_with(prefix)) continue;
        const auto* number = std::get_if<double>(&value);
        const auto* numbers = std::get_if<std::vector<double>>(&value);
        if (number) all.emplace_back(name.substr(prefix.size()), std::vector{*number});
        if (numbers) all.emplace_back(name.substr(prefix.size()), *numbers);
    }
    return all;
}

}  // namespace

ResidualGrid residual_of(const Table& table, const std::string& name)
{
    const TableHeader& header = table.header;
    const bool is_f = header.quantity == "brdf";
    if (!is_f && header.quantity != residual_quantity)
        refuse(name, fmt::format("holds `{}`", header.quantity));
    if (header.sweep_axes > 0 || grid_kind_of(header) != GridKind::rusinkiewicz)
        refuse(name, "is over other axes");
    if (header.channels.size() > max_channels)
        refuse(name, fmt::format("has {} channels", header.channels.size()));

    ResidualGrid grid;
    grid.name = name;
    grid.root = !is_evenly_spaced(header.axes[0]);
    const std::array<Axis, 3> axes{coordinates(header.axes[0], grid.root), header.axes[1],
                                   header.axes[2]};
    for (const Axis& axis : axes)
        if (!begins_at_pole(axis)) refuse(name, fmt::format("`{}` is spaced otherwise", axis.name));
    const double first = axes[2].values[0], last = axes[2].values.back();
    const bool is_half = is_near(last + (axes[2].samples == Samples::node ? 0 : first), 180);
    const double step = axes[2].values[1] - first;
    if (!is_half && !is_near(last, 90) && !is_near(last, 90 - step / 2))
        refuse(name, fmt::format("`phi_d` ends at {} deg, not at 90 or 180", last));

    const bool add_h = axes[0].samples == Samples::centre;
    const bool add_d = axes[1].samples == Samples::centre;
    grid.channels = header.channels.size();
    std::vector<Block> blocks;
    double greatest = -HUGE_VAL;
    for (const auto& plane : table.values) {
        Block block{axes[0].values.size(), axes[1].values.size(), axes[2].values.size(), plane};
        if (is_half) block = folded(std::move(block));
        if (is_f)
            for (double& value : block.values)
                value = std::log(std::numbers::pi * std::max(value, 0.0));
        go_on_below_horizon(block, header.axes, name);
        greatest = std::max(greatest, *std::ranges::max_element(block.values));
        blocks.push_back(std::move(block));
    }
    if (greatest == -HUGE_VAL) refuse(name, "holds no value above 0");
    for (Block& block : blocks) {
        for (double& value : block.values) value = std::max(value, greatest - largest_range);
        block = with_poles(std::move(block), add_h, add_d);
        for (const double value : block.values) grid.values.push_back(static_cast<float>(value));
    }
    if (grid.values.size() > most_values)
        refuse(name, fmt::format("has {} values, more than {}", grid.values.size(), most_values));

    for (const std::size_t a : {0U, 1U, 2U}) {
        if (a == 0 ? add_h : a == 1 && add_d) grid.positions[a].push_back(0);
        const double unit = a == 0 && grid.root ? std::sqrt(radian) : radian;
        for (const double value : axes[a].values) grid.positions[a].push_back(value * unit);
    }
    if (is_half) grid.positions[2].resize((grid.positions[2].size() + 1) / 2);
    grid.digest = digest_of(grid.values);
    grid.parameters = lobe_of(header);
    if (is_f) grid.parameters = {{"k_d", {1}}, {"k_s", {0}}};
    return grid;
}

Table read_residual_table(const std::filesystem::path& path)
try {
    return read_table(path);
} catch (const std::runtime_error& error) {  // of either kind: names the file
    refuse(error.what());
}

ResidualGrid read_residual(const std::filesystem::path& path)
{
    return residual_of(read_residual_table(path), path.string());
}

}  // namespace gonio
