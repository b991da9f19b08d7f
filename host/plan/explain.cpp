// SPDX-License-Identifier: Apache-2.0
// Plans in words. What they say of grids is asked of the functions that the computation asks.
#include "plan/explain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "compute/distinct_channels.hpp"
#include "compute/idle_lobes.hpp"
#include "compute/symmetry.hpp"
#include "opencl/grid_kernel.hpp"
#include "plan/batch.hpp"
#include "plan/explain_parts.hpp"
#include "quadrature/derived.hpp"

namespace gonio {
namespace {

void leave_out_models(JobPlan& plan, const Material& material)
{
    std::set<std::string_view> named;
    for (const Lobe& lobe : material.lobes) named.insert(lobe.model->id);
    leave_out(plan, fmt::format("{} of {} models", models().size() - named.size(), models().size()),
              "no lobe is one of them: they are not compiled");
}

void leave_out_lobes(JobPlan& plan, const Material& given, const Material& kept)
{
    leave_out_part(plan, "lobes", given.lobes.size(), kept.lobes.size(),
                   "their weight is 0, or they reflect nothing");
    const bool plain = std::ranges::all_of(kept.lobes, [](const Lobe& lobe) {
        return std::ranges::all_of(lobe.weight, [](double weight) { return weight == 1; });
    });
    if (plain) leave_out(plan, "weights", "all are 1");
    if (std::ranges::any_of(kept.lobes,
                            [](const Lobe& lobe) { return even_facet_reflectance(lobe) == 1; }))
        leave_out(plan, "Fresnel's reflectance", "with f0 = 1 facets reflect all light");
}

/// Has the lobe colours, all of them grey?
bool is_grey(const Lobe& lobe)
{
    bool coloured = false, grey = true;
    for (std::size_t k = 0; k < lobe.values.size(); ++k) {
        if (lobe.model->parameters[k].kind != Kind::color) continue;
        coloured = true;
        grey = grey && all_are(lobe.values[k], lobe.values[k].front());
    }
    return coloured && grey;
}

/// channels: of the table.
void leave_out_channels(JobPlan& plan, std::size_t channels, const Material& distinct)
{
    const std::size_t left = distinct.channels();
    leave_out_part(plan, "channels", channels, left, "they equal another one");
    const auto grey = std::ranges::count_if(distinct.lobes, is_grey);
    if (left > 1 && grey > 0)
        leave_out(plan, fmt::format("channels of {} of {} lobes", grey, distinct.lobes.size()),
                  "grey: what they are in one they are in all");
}

void explain_grid(JobPlan& plan, const Device& device, const Job& job)
{
    const Material& given = job.materials.front();
    const Material kept = distinct_channels(without_idle_lobes(given)).material;
    const bool mirrored = is_mirrored(kept, job.grid);
    const bool reciprocal = is_reciprocal(kept, job.measure, job.grid);
    plan.kernel = "table.cl";
    plan.width = device.width();
    if (!job.fit) {
        plan.width = fitting_width(plan.width, job.header.row_length() / (mirrored ? 2 : 1));
        plan.tiling = tiling(device.info(), job.grid, kept.channels(), reciprocal);
    }
    plan.definitions = table_definitions(kept, {"", job.measure, mirrored, reciprocal, plan.width});
    leave_out_models(plan, kept);
    leave_out_lobes(plan, given, kept);
    leave_out_channels(plan, given.channels(), kept);
    if (mirrored)
        leave_out(plan, "half of " + job.grid.axes.back().name,
                  "it is the mirror image of the other half", 2);
    if (reciprocal)
        leave_out(plan, "half of theta_i, theta_o", "light and viewer can change places", 2);
    if (kept.isotropic()) leave_out(plan, "tangent frames", "every lobe is the same along x and y");
}

/// Each lobe has a program of its own.
void add_lobe_program(JobPlan& plan, const std::vector<Material>& materials, std::size_t lobe)
{
    const auto alone = [&](const Material& material) {
        return Material{material.name, {material.lobes[lobe]}};
    };
    const bool isotropic = std::ranges::all_of(
        materials, [&](const Material& material) { return alone(material).isotropic(); });
    for (const std::string& definition : albedo_definitions(alone(materials.front()), isotropic))
        if (std::ranges::find(plan.definitions, definition) == plan.definitions.end())
            plan.definitions.push_back(definition);
}

void explain_integral(JobPlan& plan, const Device& device, const Job& job)
{
    const std::vector<Material> materials = integrated_materials(job);
    const Material& first = materials.front();
    const std::vector<std::size_t> lit = lobes_with_light(materials);
    if (job.header.quantity != "specular_reflectance") {
        plan.kernel = "albedo.cl";
        plan.width = device.width();
        for (const std::size_t lobe : lit) add_lobe_program(plan, materials, lobe);
    }
    leave_out_models(plan, first);
    leave_out_part(plan, "lobes", first.lobes.size(), lit.size(),
                   "their weight is 0, or they reflect nothing");
    leave_out(plan, "random sampling", "quadrature has no noise and knows its error");
}

std::string solver_of(const Job& job)
{
    if (job.layers) return job.layers->solver;
    if (job.skin) return job.profile ? "monte_carlo" : "adding_doubling";
    return job.cells.empty() ? "closed_form" : "quadrature";
}

}  // namespace

void leave_out(JobPlan& plan, std::string what, std::string why, std::optional<double> saving)
{
    plan.left_out.push_back({std::move(what), std::move(why), saving});
}

void leave_out_part(JobPlan& plan, const char* of, std::size_t all, std::size_t left,
                    std::string why, bool alike)
{
    if (left == all) return;
    leave_out(plan, fmt::format("{} of {} {}", all - left, all, of), std::move(why));
    if (alike) plan.left_out.back().saving = static_cast<double>(all) / static_cast<double>(left);
}

JobPlan explain(const Device& device, const Job& job)
{
    JobPlan plan;
    plan.solver = solver_of(job);
    plan.finished = is_finished(job);
    if (job.layers)
        explain_layers(plan, device, job);
    else if (job.skin)
        explain_skin(plan, device, job);
    else if (!job.cells.empty())
        explain_integral(plan, device, job);
    else
        explain_grid(plan, device, job);
    if (plan.finished)
        plan.left_out.insert(plan.left_out.begin(), {"all of it", "an earlier run made it", {}});
    return plan;
}

}  // namespace gonio
