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
#include "photon/asked_layers.hpp"
#include "photon/bins.hpp"
#include "photon/exact_values.hpp"
#include "photon/program.hpp"
#include "plan/batch.hpp"
#include "skin/spectral_bases.hpp"

namespace gonio {
namespace {

void leave_out(JobPlan& plan, std::string what, std::string why,
               std::optional<double> saving = std::nullopt)
{
    plan.left_out.push_back({std::move(what), std::move(why), saving});
}

void leave_out_models(JobPlan& plan, const Material& material)
{
    std::set<std::string_view> named;
    for (const Lobe& lobe : material.lobes) named.insert(lobe.model->id);
    leave_out(plan, fmt::format("{} of {} models", models().size() - named.size(), models().size()),
              "no lobe is one of them: they are not compiled");
}

/// part of a whole is left out, so that the work is about so much less, if all parts are alike.
void leave_out_part(JobPlan& plan, const char* of, std::size_t all, std::size_t left,
                    std::string why, bool alike = true)
{
    if (left == all) return;
    leave_out(plan, fmt::format("{} of {} {}", all - left, all, of), std::move(why));
    if (alike) plan.left_out.back().saving = static_cast<double>(all) / static_cast<double>(left);
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

void explain_integral(JobPlan& plan, const Device& device, const Job& job)
{
    plan.kernel = "albedo.cl";
    plan.width = device.width();
    const Material& first = job.materials.front();
    leave_out_models(plan, first);
    leave_out_part(plan, "lobes", first.lobes.size(), lobes_with_light(job.materials).size(),
                   "their weight is 0, or they reflect nothing");
    leave_out(plan, "random sampling", "quadrature has no noise and knows its error");
}

/// Photons have such a standard error of a fraction near 1/2; 0 where a time alone is asked for.
void leave_out_photons(JobPlan& plan, double error)
{
    std::string why = "adding-doubling has no noise";
    if (error > 0)
        why += fmt::format(", and {:.0e} photons have an error of {:.0e}", 0.25 / (error * error),
                           error);
    leave_out(plan, "photons", why);
}

void explain_layers(JobPlan& plan, const Device& device, const Job& job)
{
    const LightJob& light = *job.layers;
    const AskedLayers asked = asked_layers(job);
    const std::size_t all = light.medium.layers.size(), left = asked.medium.layers.size();
    // Few photons come to where none is needed: the bench's savings have none of this.
    const bool alike = light.solver == "adding_doubling";
    leave_out_part(plan, "layers", all, all - asked.clear,
                   "clear, of their neighbour's index, and nobody asks for them", alike);
    leave_out_part(
        plan, "layers", left + asked.unreached, left,
        fmt::format("less than {:.0e} of the light comes as far and back", asked.returned), alike);
    if (light.solver == "adding_doubling") return leave_out_photons(plan, tolerance_of(light));
    const PhotonTallies tallies = tallies_of(*light.quantity, job.header.axes);
    plan.kernel = "photon/transport.cl";
    plan.width = device.width();
    plan.definitions =
        photon_program(asked.medium, {.light = light.light, .tallies = tallies}).definitions;
    const auto unless = [&](bool tallied, const char* what) {
        if (!tallied) leave_out(plan, what, "nobody asks for it: neither compiled nor allocated");
    };
    unless(tallies.reflected, "the tally of reflected light");
    unless(tallies.transmitted, "the tally of transmitted light");
    unless(tallies.absorbed, "the tally of absorbed light");
}

void explain_skin(JobPlan& plan, const Device& device, const Job& job)
{
    if (job.profile) {
        plan.kernel = "photon/transport.cl";
        plan.width = device.width();
        if (job.header.quantity != "reflectance_r")
            return leave_out(plan, "wavelengths between every 20 nm", "colour does not need them",
                             4);
        const auto& wavelengths = (job.header.axes.end() - 2)->values;
        const std::size_t bases =
            spectral_bases(media_of(job.skin->skin, wavelengths), spacing_of(*job.profile)).size();
        if (bases == wavelengths.size()) return;
        return leave_out(plan, "photons of their own for each wavelength",
                         fmt::format("on the paths of {} absorption is exchanged", bases),
                         static_cast<double>(wavelengths.size()) / static_cast<double>(bases));
    }
    leave_out_photons(plan, job.skin->tolerance);
    if (!job.skin->ladders.empty() || job.header.axes.back().name == "d")
        leave_out(plan, "layers that several sets or folds share",
                  "they are solved once at a wavelength");
}

std::string solver_of(const Job& job)
{
    if (job.layers) return job.layers->solver;
    if (job.skin) return job.profile ? "monte_carlo" : "adding_doubling";
    return job.cells.empty() ? "closed_form" : "quadrature";
}

}  // namespace

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
