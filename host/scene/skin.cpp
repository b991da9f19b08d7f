// SPDX-License-Identifier: Apache-2.0
// Reads skin as a material, and what a table of it asks for.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gonio/skin.hpp"
#include "scene/bins.hpp"
#include "scene/material.hpp"
#include "scene/sweep.hpp"
#include "scene/table.hpp"
#include "skin/skin_sets.hpp"

namespace gonio {
namespace {

/// Sets a parameter to each of its values, the first at last.
void set(Skin& skin, const Value& value, const std::vector<double>& numbers)
{
    located(value.where(), [&] {
        for (auto number = numbers.rbegin(); number != numbers.rend(); ++number)
            skin.set(value.name(), *number);
    });
}

constexpr double greatest_thickness = 10;  // cm

/// The quantity's axes, all of them; only the wavelengths of a spectrum may be left away.
void read_own_axes(const Section& table, TableRequest& request)
{
    const Quantity& quantity = *request.quantity;
    const auto axes = table.find("axes");
    if (axes && quantity.axes.empty())
        axes->fail(fmt::format("the quantity `{}` has no axes", quantity.id));
    if (!axes && quantity.id == "reflectance_spectrum")
        request.axes = {{"wavelength", "nm", default_wavelengths(), Samples::node}};
    else if (!quantity.axes.empty())
        name_axes(table.at("axes"), request);
    for (const Axis& axis : request.axes)
        for (const double value : axis.values)
            if (axis.name == "d" && !(value > 0 && value <= greatest_thickness))
                axes->fail(fmt::format("`d` is {}; allowed is above 0, up to {} cm", value,
                                       greatest_thickness));
}

}  // namespace

Skin read_skin(const Section& material, std::vector<Sweep>& sweeps)
{
    const Value name = material.at("skin");
    Skin skin = located(name.where(), [&] { return Skin(find_skin_model(name.text())); });
    const auto parameters = material.find("parameters");
    if (!parameters) return skin;
    for (const Value& value : Section(*parameters).values()) {
        located(value.where_key(), [&] { skin.model().index_of(value.name()); });
        const bool swept = value.is_table();
        const double number = read_swept_number(value, 0, sweeps);
        set(skin, value, swept ? sweeps.back().values : std::vector{number});
    }
    return skin;
}

LayeredMedium read_skin_layers(const Section& material)
{
    std::vector<Sweep> sweeps;
    const Skin skin = read_skin(material, sweeps);
    const Value wavelength = material.at("wavelength");
    if (!sweeps.empty())
        throw UsageError(sweeps.front().where +
                         "skin at one wavelength is layers, which have no sweeps");
    return located(wavelength.where(), [&] { return skin.layers_at(wavelength.number()); });
}

void read_skin_request(const Section& table, const Skin& skin, TableRequest& request)
{
    if (request.solver == "monte_carlo") return read_profile_request(table, skin, request);
    if (const auto time = table.find("time"))
        time->fail(
            "`time` is for light that spreads, by photons; without noise each wavelength has the "
            "fewest nodes that keep to `max_error`");
    table.allow({"material", "name", "quantity", "axes", "light", "theta_i", "solver", "max_error",
                 "format", "precision", "compression"});
    if (const auto light = table.find("light"))
        request.light.beam = light->choice({"beam", "diffuse"}) == 1 ? Beam::diffuse : Beam::pencil;
    if (const auto theta = table.find("theta_i")) {
        if (request.light.beam == Beam::diffuse)
            theta->fail("`theta_i` is for a beam, not for diffuse light");
        request.light.incidence =
            theta->number(0, std::nextafter(90.0, 0.0)) * std::numbers::pi / 180;
    }
    read_own_axes(table, request);
    const auto axes = table.find("axes");
    const Value place = axes ? *axes : table.at("quantity");
    located(place.where(), [&] {
        for (const double wavelength : wavelengths_of(request))
            static_cast<void>(skin.layers_at(wavelength));
    });
}

}  // namespace gonio
