// SPDX-License-Identifier: Apache-2.0
// What a header tells of a table's grid.
#include "plan/grid_header.hpp"

#include <algorithm>

#include "compute/horizon.hpp"

namespace gonio {
namespace {

/// In place of what the attribute was, or behind all others.
void put(TableHeader& header, std::string_view name, double value)
{
    const auto found = std::ranges::find(header.attributes, name,
                                         [](const auto& attribute) { return attribute.first; });
    if (found == header.attributes.end())
        header.attributes.emplace_back(name, value);
    else
        found->second = value;
}

}  // namespace

std::string grid_name(GridKind kind)
{
    switch (kind) {
        case GridKind::isotropic:
            return "isotropic";
        case GridKind::anisotropic:
            return "anisotropic";
        default:
            return "rusinkiewicz";
    }
}

std::string directions_text(GridKind kind)
{
    switch (kind) {
        case GridKind::isotropic:
            return "normal +z; light at (theta_i, azimuth 0), viewer at (theta_o, azimuth "
                   "delta_phi): "
                   "delta_phi = 180 deg is the mirror direction";
        case GridKind::anisotropic:
            return "normal +z, tangent +x; light at (theta_i, phi_i), viewer at (theta_o, phi_o), "
                   "azimuths from +x towards +y";
        default:
            return "normal +z; half vector at (theta_h, azimuth 0), light at (theta_d, phi_d) in "
                   "its "
                   "frame (Rusinkiewicz, EGWR 1998); 0 where light or viewer is below the horizon";
    }
}

std::size_t cells_at_the_horizon(const Grid& grid)
{
    std::size_t cells = 1, above = 1;
    for (const Axis& axis : grid.axes) {
        const bool polar = axis.name == "theta_i" || axis.name == "theta_o";
        const bool ends_there = polar && axis.values.back() == 90;
        cells *= axis.values.size();
        above *= axis.values.size() - (ends_there ? 1 : 0);
    }
    return cells - above;
}

void count_horizon(Job& job)
{
    if (!touches_horizon(job.grid)) return;
    std::size_t poles = 0;
    for (const Material& material : job.materials)
        poles += count_poles(make_reference(material, job.measure), job.grid,
                             job.header.channels.size());
    put(job.header, "horizon.without_limit", static_cast<double>(poles));
}

void set_grid(Job& job, const Grid& grid, double interpolation_error)
{
    job.grid = grid;
    job.interpolation_error = interpolation_error;
    TableHeader& header = job.header;
    std::ranges::copy(grid.axes, header.axes.end() - std::ssize(grid.axes));
    put(header, "interpolation.error", interpolation_error);
    if (const auto cells = cells_at_the_horizon(grid); cells != 0)
        put(header, "horizon.cells", static_cast<double>(cells));
    count_horizon(job);
}

}  // namespace gonio
