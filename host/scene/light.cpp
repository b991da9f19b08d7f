// SPDX-License-Identifier: Apache-2.0
// Reads what a table of layers asks for: how they are lit, and over what.
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "grid/azimuths.hpp"
#include "scene/bins.hpp"
#include "scene/table.hpp"

namespace gonio {
namespace {

/// What the solvers of a BRDF can fill.
void check_grid(const Value& where, const TableRequest& request)
{
    const Grid& grid = *request.grid;
    if (grid.kind != GridKind::isotropic || grid.axes[0].samples != Samples::centre)
        where.fail(
            "layers have their BRDF on a grid of kind = \"isotropic\" with samples = "
            "\"centre\"");
    const Axis& azimuth = grid.axes[2];
    if (request.solver == "monte_carlo" && covers_whole_turn(azimuth) &&
        azimuth.values.size() % 2 != 0)
        where.fail("bins over 360 deg of `delta_phi` must be even in number, or end at 180 deg");
}

/// A list of incident directions.
void check_cosines(const Section& table, TableRequest& request)
{
    const Value where = table.at("axes");
    if (request.axes.size() != 1 || request.axes[0].name != "mu")
        where.fail(
            "the quantity `directional_albedo` of layers needs axes = { mu = { to = 1, "
            "count = … } }");
    request.axes[0].unit = request.quantity->axes[0].unit;
    for (const double mu : request.axes[0].values)
        if (!(mu > 0 && mu <= 1))
            where.fail(
                fmt::format("`mu` is {}; the cosine of an incident direction must be above "
                            "0 and at most 1",
                            mu));
}

/// Parts of the light that are reflected.
void check_albedos(const Value& axes, TableRequest& request)
{
    name_axes(axes, request);
    for (const double albedo : request.axes[0].values)
        if (!(albedo >= 0 && albedo <= 1))
            axes.fail(fmt::format("`albedo` is {}; allowed is 0 to 1", albedo));
}

/// Which light, and what it needs. A quantity with directions of its own has no other.
void read_light(const Section& table, TableRequest& request)
{
    LightSource& light = request.light;
    const std::string_view id = request.quantity->id;
    if (id == "brdf" || id == "directional_albedo" || id == "mean_albedo") {
        if (id == "mean_albedo") light.beam = Beam::diffuse;
        for (const auto key : {"light", "theta_i", "radius"})
            if (const auto value = table.find(key))
                value->fail(fmt::format(
                    "the quantity `{}` says itself how light comes in and has no `{}`", id, key));
        return;
    }
    static const std::vector<std::string_view> beams = {"beam", "gaussian", "top_hat", "diffuse"};
    if (const auto beam = table.find("light")) light.beam = static_cast<Beam>(beam->choice(beams));
    if (const auto theta = table.find("theta_i")) {
        if (light.beam == Beam::diffuse)
            theta->fail("`theta_i` is for a beam, not for diffuse light");
        light.incidence = theta->number(0, std::nextafter(90.0, 0.0)) * std::numbers::pi / 180;
    }
    const bool wide = light.beam == Beam::gaussian || light.beam == Beam::top_hat;
    if (wide) light.radius = table.at("radius").number(0, 1e6);
    const auto radius = table.find("radius");
    if (radius && !wide)
        radius->fail("`radius` is for light = \"gaussian\" and light = \"top_hat\"");
}

/// Rather than solved once with more and more nodes.
bool searches(std::string_view id)
{
    return id == "mean_path" || id == "single_scattering_albedo";
}

}  // namespace

void read_light_request(const Section& table, TableRequest& request)
{
    const Quantity& quantity = *request.quantity;
    if (const auto grid = table.find("grid"); grid && !quantity.on_grid())
        grid->fail(fmt::format("the quantity `{}` has no `grid`", quantity.id));
    if (quantity.on_grid()) check_grid(table.at("grid"), request);
    read_light(table, request);
    if (const auto seed = table.find("seed"))
        request.seed = seed->count(0, std::numeric_limits<std::int64_t>::max());
    if (quantity.id == "directional_albedo")
        check_cosines(table, request);
    else if (quantity.id == "single_scattering_albedo")
        check_albedos(table.at("axes"), request);
    else if (!quantity.on_grid())
        read_bins(table, request);
    if (request.solver != "adding_doubling") return;
    if (const auto time = table.find("time"); time && searches(quantity.id))
        time->fail(
            fmt::format("the quantity `{}` has no `time`: its numbers are searched for, each until "
                        "it is exact",
                        quantity.id));
    if (const auto error = table.find("max_error"); error && quantity.id == "mean_path")
        error->fail(
            "the quantity `mean_path` has no `max_error`: it is as exact as it can be, and its "
            "error is beside it");
    for (const auto key : {"photons", "seed"})
        if (const auto value = table.find(key))
            value->fail(
                fmt::format("`{}` is for solver = \"monte_carlo\", not adding_doubling, "
                            "which has no noise",
                            key));
}

}  // namespace gonio
