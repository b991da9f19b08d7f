// SPDX-License-Identifier: Apache-2.0
// Writes layers, light and budget into the header of a table.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <numbers>

#include "plan/grid_header.hpp"
#include "plan/header.hpp"
#include "version.hpp"

namespace gonio {
namespace {

struct PhaseText {
    std::string operator()(const HenyeyGreenstein& phase) const
    {
        return fmt::format("henyey_greenstein g {}", phase.g);
    }
    std::string operator()(const Isotropic&) const { return "isotropic"; }
    std::string operator()(const Rayleigh&) const { return "rayleigh"; }
    std::string operator()(const TwoTermHenyeyGreenstein& phase) const
    {
        return fmt::format("two_term g_1 {} g_2 {} weight_1 {}", phase.g_1, phase.g_2,
                           phase.weight_1);
    }
    std::string operator()(const TabulatedPhase& phase) const
    {
        return fmt::format("tabulated cosine {} value {}", fmt::join(phase.cosine, " "),
                           fmt::join(phase.value, " "));
    }
};

std::string bottom_text(const LayeredMedium& medium)
{
    switch (medium.bottom) {
        case Bottom::open:
            return "open";
        case Bottom::black:
            return "black";
        case Bottom::mirror:
            return "mirror";
        default:
            return fmt::format("diffuse, albedo {}", medium.bottom_albedo);
    }
}

/// A value and the standard error beside it. Adding-doubling has one bound for all values.
std::vector<std::string> channels(const LightJob& job)
{
    std::vector<std::string> names = {"Y"};
    const auto add_layers = [&](std::string_view of) {
        for (std::size_t k = 1; k <= job.medium.layers.size(); ++k)
            names.push_back(fmt::format("{}layer_{}", of, k));
    };
    if (job.quantity->id == "light_budget") {
        names = {"specular", "diffuse_reflectance", "unscattered_transmittance",
                 "diffuse_transmittance", "bottom"};
        add_layers("");
    } else if (job.quantity->id == "mean_path") {
        names.clear();
        add_layers("reflected.");
        add_layers("transmitted.");
    }
    const std::size_t values = names.size();
    for (std::size_t k = 0; k < values; ++k) names.push_back(names[k] + ".error");
    return names;
}

using Attributes = std::vector<std::pair<std::string, Attribute>>;

void add_medium(Attributes& all, const LayeredMedium& medium)
{
    std::vector<double> mua, mus, n, d;
    std::string phases;
    for (const Layer& layer : medium.layers) {
        mua.push_back(layer.mua);
        mus.push_back(layer.mus);
        n.push_back(layer.n);
        if (std::isfinite(layer.d)) d.push_back(layer.d);
        phases += (phases.empty() ? "" : "; ") + std::visit(PhaseText{}, layer.phase);
    }
    all.emplace_back("n_above", medium.n_above);
    all.emplace_back("n_below", medium.n_below);
    all.emplace_back("bottom", bottom_text(medium));
    all.emplace_back("layers.mua", mua);
    all.emplace_back("layers.mua.unit", std::string("1/cm"));
    all.emplace_back("layers.mus", mus);
    all.emplace_back("layers.mus.unit", std::string("1/cm"));
    all.emplace_back("layers.n", n);
    if (!d.empty()) {
        all.emplace_back("layers.d", d);
        all.emplace_back("layers.d.unit", std::string("cm"));
    }
    if (d.size() < n.size()) all.emplace_back("layers.last", std::string("infinite"));
    all.emplace_back("layers.phase", phases);
}

void add_light(Attributes& all, const LightSource& light)
{
    static constexpr std::array names = {"beam", "gaussian", "top_hat", "diffuse"};
    all.emplace_back("light", std::string(names[static_cast<std::size_t>(light.beam)]));
    if (light.beam == Beam::diffuse) return;
    all.emplace_back("theta_i", light.incidence * 180 / std::numbers::pi);
    all.emplace_back("theta_i.unit", std::string("deg"));
    if (light.beam == Beam::pencil) return;
    all.emplace_back("radius", light.radius);
    all.emplace_back("radius.unit", std::string("cm"));
}

}  // namespace

TableHeader make_light_header(const Job& job, const std::string& material,
                              const std::vector<Axis>& axes)
{
    const LightJob& light = *job.layers;
    TableHeader header;
    header.quantity = light.quantity->id;
    header.unit = light.quantity->unit;
    header.axes = axes;
    header.channels = channels(light);
    header.single_precision = job.format == "exr";
    Attributes& all = header.attributes;
    all.emplace_back("program", std::string(GONIO_PROGRAM));
    all.emplace_back("title", std::string(light.quantity->title));
    all.emplace_back("solver", light.solver);
    all.emplace_back("storage", storage_text(job));
    all.emplace_back("material", material);
    if (light.quantity->on_grid()) {
        all.emplace_back("grid", grid_name(GridKind::isotropic));
        all.emplace_back("directions", directions_text(GridKind::isotropic));
    } else if (axes.empty() || axes.front().name != "mu") {
        add_light(all, light.light);
    }
    add_medium(all, light.medium);
    if (light.budget.max_error) all.emplace_back("max_error", *light.budget.max_error);
    if (light.solver == "monte_carlo") all.emplace_back("seed", static_cast<double>(light.seed));
    if (light.budget.photons)
        all.emplace_back("photons", static_cast<double>(*light.budget.photons));
    if (light.budget.seconds) {
        all.emplace_back("time", *light.budget.seconds);
        all.emplace_back("time.unit", std::string("s"));
    }
    return header;
}

}  // namespace gonio
