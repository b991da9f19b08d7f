// SPDX-License-Identifier: Apache-2.0
// Reads skin as a material, and what a table of it asks for.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gonio/skin.hpp"
#include "scene/material.hpp"
#include "scene/sweep.hpp"
#include "scene/table.hpp"

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
    const auto axes = table.find("axes");
    if (axes && request.quantity->axes.empty())
        axes->fail(fmt::format("the quantity `{}` has no axes", request.quantity->id));
    if (axes && (request.axes.size() != 1 || request.axes[0].name != "wavelength"))
        axes->fail(
            fmt::format("the quantity `{}` needs axes = {{ wavelength = {{ from = 380, to = "
                        "780, count = 81 }} }}",
                        request.quantity->id));
    if (!axes) request.axes = {{"wavelength", "nm", default_wavelengths(), Samples::node}};
    request.axes[0].unit = "nm";
    const Value place = axes ? *axes : table.at("quantity");
    located(place.where(), [&] {
        for (const double wavelength : request.axes[0].values)
            static_cast<void>(skin.layers_at(wavelength));
    });
}

}  // namespace gonio
