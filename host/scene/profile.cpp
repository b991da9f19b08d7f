// SPDX-License-Identifier: Apache-2.0
// Reads what a table of the light that spreads in skin asks for.
#include <fmt/format.h>

#include <limits>

#include "scene/bins.hpp"
#include "scene/table.hpp"

namespace gonio {
namespace {

constexpr double greatest_curvature = 10;  // 1/mm: smaller than a pore

void check_range(const Value& axes, const Axis& axis, double least, double greatest)
{
    for (const double value : axis.values)
        if (!(value >= least && value <= greatest))
            axes.fail(
                fmt::format("`{}` is {}; allowed is {} to {}", axis.name, value, least, greatest));
}

void check_wavelengths(const Value& axes, const Skin& skin, const Axis& axis)
{
    located(axes.where(), [&] {
        for (const double wavelength : axis.values) static_cast<void>(skin.layers_at(wavelength));
    });
}

}  // namespace

void read_profile_request(const Section& table, const Skin& skin, TableRequest& request)
{
    const bool spectrum = request.quantity->id == "reflectance_r";
    std::vector<std::string_view> keys = {"material",  "name",        "quantity", "axes",
                                          "solver",    "photons",     "seed",     "format",
                                          "precision", "compression", "time"};
    if (spectrum) keys.insert(keys.end(), {"max_error", "ring_error"});
    table.allow(keys);
    if (const auto seed = table.find("seed"))
        request.seed = seed->count(0, std::numeric_limits<std::int64_t>::max());
    // Photons of a wavelength have numbers of 48 bits.
    if (const auto photons = table.find("photons"))
        request.budget.photons = photons->count(2, std::uint64_t{1} << 48);
    if (const auto error = table.find("ring_error"))
        request.budget.ring_error = error->number(least_error, 1);
    if (spectrum || request.quantity->id == "profile_rgb") read_bins(table, request);
    if (spectrum) check_wavelengths(table.at("axes"), skin, request.axes[0]);
    if (request.quantity->id != "preintegrated_rgb") return;
    const Value axes = table.at("axes");
    name_axes(axes, request);
    check_range(axes, request.axes[0], -1, 1);
    check_range(axes, request.axes[1], 0, greatest_curvature);
}

}  // namespace gonio
