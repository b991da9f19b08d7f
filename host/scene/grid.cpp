// SPDX-License-Identifier: Apache-2.0
// Reads the grid of a table, and the axes of one that has no grid.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/sweep.hpp"
#include "scene/table.hpp"

namespace gonio {
namespace {

constexpr double max_cells = 0x1p50;  // 4 PiB of float32 in a channel

Samples read_samples(const Section& section)
{
    const auto samples = section.find("samples");
    return samples && samples->choice({"centre", "node"}) == 1 ? Samples::node : Samples::centre;
}

/// The counts under these keys. What cannot be counted is refused with the size of the whole.
std::vector<std::size_t> read_counts(const Section& grid, const std::vector<std::string_view>& keys)
{
    double cells = 1;
    bool countable = true;
    for (const auto key : keys) {
        const Value value = grid.at(key);
        if (value.is_number()) cells *= value.number();
        countable = countable && value.is_number() && value.number() >= 1;
    }
    if (countable && cells > max_cells)
        grid.fail(
            fmt::format("a grid of {:.3g} cells, {:.3g} GiB for each channel; allowed are "
                        "{:.3g} cells",
                        cells, cells * sizeof(float) / 0x1p30, max_cells));
    std::vector<std::size_t> counts;
    for (const auto key : keys) counts.push_back(grid.at(key).count(1, max_samples));
    return counts;
}

double read_delta_phi_to(const Section& grid)
{
    const auto end = grid.find("delta_phi_to");
    const double to = end ? end->number() : 360;
    if (to != 180 && to != 360)
        end->fail(fmt::format("`delta_phi_to` is {}; allowed is 180 or 360 deg", to));
    return to;
}

Spacing read_spacing(const Section& grid)
{
    const auto spacing = grid.find("spacing");
    return spacing && spacing->choice({"linear", "merl"}) == 1 ? Spacing::merl : Spacing::linear;
}

Grid read_isotropic(const Section& grid)
{
    grid.allow({"kind", "theta_i", "theta_o", "delta_phi", "samples", "delta_phi_to"});
    const auto counts = read_counts(grid, {"theta_i", "theta_o", "delta_phi"});
    const double to = read_delta_phi_to(grid);
    const auto samples = read_samples(grid);
    return located(grid.where(),
                   [&] { return isotropic_grid(counts[0], counts[1], counts[2], samples, to); });
}

Grid read_anisotropic(const Section& grid)
{
    grid.allow({"kind", "theta_i", "phi_i", "theta_o", "phi_o", "samples"});
    const auto counts = read_counts(grid, {"theta_i", "phi_i", "theta_o", "phi_o"});
    const auto samples = read_samples(grid);
    return located(grid.where(), [&] {
        return anisotropic_grid(counts[0], counts[1], counts[2], counts[3], samples);
    });
}

Grid read_rusinkiewicz(const Section& grid)
{
    grid.allow({"kind", "theta_h", "theta_d", "phi_d", "samples", "spacing"});
    const auto counts = read_counts(grid, {"theta_h", "theta_d", "phi_d"});
    const auto spacing = read_spacing(grid);
    const auto samples = read_samples(grid);
    return located(grid.where(), [&] {
        return rusinkiewicz_grid(counts[0], counts[1], counts[2], samples, spacing);
    });
}

/// Squares of evenly spaced numbers: even in the root.
Axis square_axis(const std::string& name, double from, double to, std::size_t count,
                 Samples samples)
{
    Axis axis = make_axis(name, std::sqrt(from), std::sqrt(to), count, samples);
    for (double& value : axis.values) value *= value;
    if (samples == Samples::node) {
        axis.values.front() = from;
        axis.values.back() = to;
    }
    return axis;
}

}  // namespace

Grid read_grid(const Value& value)
{
    const Section grid(value);
    using Reader = Grid (*)(const Section&);
    static constexpr std::array<Reader, 3> readers{read_isotropic, read_anisotropic,
                                                   read_rusinkiewicz};
    const auto kind = grid.at("kind").choice({"isotropic", "anisotropic", "rusinkiewicz"});
    return readers[kind](grid);
}

std::optional<GridFit> read_grid_fit(const Value& value)
{
    const Section grid(value);
    for (const auto key :
         {"theta_i", "theta_o", "delta_phi", "phi_i", "phi_o", "theta_h", "theta_d", "phi_d"})
        if (grid.find(key)) return std::nullopt;
    GridFit fit;
    fit.kind =
        static_cast<GridKind>(grid.at("kind").choice({"isotropic", "anisotropic", "rusinkiewicz"}));
    std::vector<std::string_view> keys{"kind", "samples", "interpolation"};
    if (fit.kind == GridKind::isotropic) keys.emplace_back("delta_phi_to");
    if (fit.kind == GridKind::rusinkiewicz) keys.emplace_back("spacing");
    grid.allow(keys);
    fit.samples = read_samples(grid);
    fit.spacing = read_spacing(grid);
    fit.delta_phi_to = read_delta_phi_to(grid);
    const auto interpolation = grid.find("interpolation");
    fit.cubic = interpolation && interpolation->choice({"linear", "cubic"}) == 1;
    return fit;
}

std::vector<Axis> read_axes(const Value& value)
{
    std::vector<Axis> axes;
    for (const Value& entry : Section(value).values()) {
        const Section axis(entry);
        if (axis.find("values")) {
            axis.allow({"values"});
            axes.push_back({entry.name(), "", read_sweep(entry, 0).values, Samples::node});
            continue;
        }
        axis.allow({"from", "to", "count", "samples", "spacing"});
        const auto spacing = axis.find("spacing");
        const bool square = spacing && spacing->choice({"linear", "square"}) == 1;
        const double from = axis.find("from") ? axis.at("from").number() : 0;
        const double to = axis.at("to").number();
        if (from == to) axis.fail(fmt::format("an axis from {} to {}", from, to));
        const auto count = static_cast<std::size_t>(axis.at("count").count(1, max_samples));
        const auto samples = read_samples(axis);
        if (square && !(std::min(from, to) >= 0))
            axis.fail("spacing = \"square\" is for numbers from 0 on");
        axes.push_back(located(axis.where(), [&] {
            return square ? square_axis(entry.name(), from, to, count, samples)
                          : make_axis(entry.name(), from, to, count, samples);
        }));
    }
    return axes;
}

}  // namespace gonio
