// SPDX-License-Identifier: Apache-2.0
// The options of a grid on the command line.
#include "commands/grid_options.hpp"

#include <fmt/format.h>

#include <charconv>

#include "gonio/errors.hpp"

namespace gonio {
namespace {

constexpr auto default_counts = "90x90x360";

/// "90x90x360" -> 90, 90, 360
std::vector<std::size_t> counts_of(const std::string& text)
{
    std::vector<std::size_t> counts;
    for (const std::string& part : CLI::detail::split(text, 'x')) {
        std::size_t count = 0;
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), count);
        if (error != std::errc() || end != part.data() + part.size())
            throw UsageError(fmt::format(
                "--grid is \"{}\"; allowed are whole numbers with x between, e.g. 90x90x360",
                text));
        counts.push_back(count);
    }
    return counts;
}

Samples samples_of(const GridOptions& options)
{
    return options.samples == "node" ? Samples::node : Samples::centre;
}

Spacing spacing_of(const GridOptions& options)
{
    return options.spacing == "merl" ? Spacing::merl : Spacing::linear;
}

}  // namespace

void GridOptions::add_to(CLI::App& verb)
{
    verb.add_option(
        "--grid", counts,
        fmt::format("samples per axis, e.g. 32x64x32x64 (default: {})", default_counts));
    verb.add_option("--kind", kind, "kind of the grid (default: by the number of axes)")
        ->check(CLI::IsMember({"isotropic", "anisotropic", "rusinkiewicz"}));
    verb.add_option("--samples", samples, "samples in cells' centres or on nodes")
        ->check(CLI::IsMember({"centre", "node"}));
    verb.add_option("--spacing", spacing, "of theta_h on a Rusinkiewicz grid")
        ->check(CLI::IsMember({"linear", "merl"}));
    verb.add_option("--interpolation", interpolation,
                    "how the table will be read, for --max-error and --time (default: linear)")
        ->check(CLI::IsMember({"linear", "cubic"}));
}

Grid GridOptions::grid() const
{
    if (!interpolation.empty())
        throw UsageError(
            "--interpolation is for grids that --max-error or --time choose the counts of");
    const std::vector<std::size_t> n = counts_of(counts.empty() ? default_counts : counts);
    const std::string of = kind.empty() ? (n.size() == 4 ? "anisotropic" : "isotropic") : kind;
    if (n.size() != (of == "anisotropic" ? 4U : 3U))
        throw UsageError(
            fmt::format("--grid {} has {} axes; {} grids have {}", counts, n.size(), of,
                        of == "anisotropic" ? "4: theta_i, phi_i, theta_o, phi_o" : "3"));
    if (of == "anisotropic") return anisotropic_grid(n[0], n[1], n[2], n[3], samples_of(*this));
    if (of == "rusinkiewicz")
        return rusinkiewicz_grid(n[0], n[1], n[2], samples_of(*this), spacing_of(*this));
    return isotropic_grid(n[0], n[1], n[2], samples_of(*this));
}

GridFit GridOptions::fit() const
{
    if (!counts.empty())
        throw UsageError("--grid has counts: leave it away, and --max-error or --time choose them");
    return {.kind = kind == "anisotropic"    ? GridKind::anisotropic
                    : kind == "rusinkiewicz" ? GridKind::rusinkiewicz
                                             : GridKind::isotropic,
            .samples = samples_of(*this),
            .spacing = spacing_of(*this),
            .cubic = interpolation == "cubic"};
}

}  // namespace gonio
