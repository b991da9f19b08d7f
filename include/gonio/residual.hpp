// SPDX-License-Identifier: Apache-2.0
// A grid of ratios between a table and a lobe: a parameter of kind TABLE.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gonio/table.hpp"

namespace gonio {

/// The quantity of a table that holds log(f / lobe).
inline constexpr std::string_view residual_quantity = "brdf_log_ratio";

/// Natural logarithms of f over the lobe, to be interpolated linearly: f = lobe exp(residual) is
/// positive, and nothing cancels. Over Rusinkiewicz's angles in radians, 0 to 90 degrees each.
/// phi_d is folded: an isotropic material whose mirror image it is itself gives the same at phi_d,
/// -phi_d and, by reciprocity, 180 - phi_d.
struct ResidualGrid {
    /// theta_h (or, if `root`, its square root), theta_d, phi_d; two samples or more, evenly spaced
    /// from the second on. The first thetas are 0: at a pole phi_d has no meaning, and the samples
    /// there are a mean. Outside the samples of phi_d the nearest counts.
    std::array<std::vector<double>, 3> positions;
    bool root = false;  ///< MERL's spacing

    std::size_t channels = 0;
    std::vector<float> values;  ///< [channel][theta_h][theta_d][phi_d]
    std::string name;           ///< of the file that it came from
    std::string digest;         ///< of the values

    /// Parameters of the lobe that the grid was made for.
    std::vector<std::pair<std::string, std::vector<double>>> parameters;

    std::size_t plane() const  ///< values of a channel
    {
        return positions[0].size() * positions[1].size() * positions[2].size();
    }
};

/// Reads the residual that `gonio compress` wrote, or takes a table of f over these angles (a MERL
/// .binary too) as the residual of the lobe k_d/pi with k_d = 1. Ratios below 1e-15 of the greatest
/// count as that, those of f = 0 and of negative values too, which have no logarithm. Below the
/// horizon, and where a file has no value (NaN, or MERL's -1) from some theta_d to the horizon, the
/// last value above goes on. Throws UsageError for other files and tables, and where a value is
/// missing in between or infinite.
ResidualGrid read_residual(const std::filesystem::path& path);

/// The same of a table that is in memory; `name` is for messages.
ResidualGrid residual_of(const Table& table, const std::string& name);

/// read_table() for files that the user names: throws UsageError, which says what is allowed.
Table read_residual_table(const std::filesystem::path& path);

}  // namespace gonio
