// SPDX-License-Identifier: Apache-2.0
// Plans in words: light in layers and in skin.
#include <fmt/format.h>

#include <algorithm>

#include "photon/asked_layers.hpp"
#include "photon/bins.hpp"
#include "photon/exact_values.hpp"
#include "photon/program.hpp"
#include "plan/explain_parts.hpp"
#include "skin/base_tracer.hpp"
#include "skin/spectral_bases.hpp"

namespace gonio {
namespace {

/// Photons have such a standard error of a fraction near 1/2; 0 where a time alone is asked for.
void leave_out_photons(JobPlan& plan, double error)
{
    std::string why = "adding-doubling has no noise";
    if (error > 0)
        why += fmt::format(", and {:.0e} photons have an error of {:.0e}", 0.25 / (error * error),
                           error);
    leave_out(plan, "photons", why);
}

void explain_photons(JobPlan& plan, const Device& device, const LayeredMedium& medium,
                     const PhotonRequest& request)
{
    const PhotonProgram program = photon_program(medium, request);
    plan.kernel = "photon/transport.cl";
    plan.width = device.width();
    plan.definitions = program.definitions;
    plan.tally_bytes = program.sums * sizeof(std::uint64_t);
}

void explain_profile(JobPlan& plan, const Device& device, const Job& job)
{
    const bool spectrum = job.header.quantity == "reflectance_r";
    std::vector<LayeredMedium> media;
    if (spectrum)
        media = media_of(job.skin->skin, (job.header.axes.end() - 2)->values);
    else
        for (const ColourBand& band : bands_of(job.skin->skin)) media.push_back(band.layers);
    const auto bases = spectral_bases(media, spacing_of(*job.profile));
    const SpectralBase& most = *std::ranges::max_element(
        bases, {}, [](const SpectralBase& base) { return base.shares.size(); });
    explain_photons(plan, device, most.medium, photon_request(most, 0, *job.profile));
    if (!spectrum)
        leave_out(plan, "wavelengths between every 20 nm", "colour does not need them", 4);
    if (bases.size() < media.size())
        leave_out(plan, "photons of their own for each wavelength",
                  fmt::format("on the paths of {} absorption is exchanged", bases.size()),
                  static_cast<double>(media.size()) / static_cast<double>(bases.size()));
}

}  // namespace

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
    explain_photons(plan, device, asked.medium, {.light = light.light, .tallies = tallies});
    const auto unless = [&](bool tallied, const char* what) {
        if (!tallied) leave_out(plan, what, "nobody asks for it: neither compiled nor allocated");
    };
    unless(tallies.reflected, "the tally of reflected light");
    unless(tallies.transmitted, "the tally of transmitted light");
    unless(tallies.absorbed, "the tally of absorbed light");
}

void explain_skin(JobPlan& plan, const Device& device, const Job& job)
{
    if (job.profile) return explain_profile(plan, device, job);
    leave_out_photons(plan, job.skin->tolerance);
    const bool folds = job.header.quantity.starts_with("transmittance");
    if (!job.skin->ladders.empty() || folds)
        leave_out(plan, "layers that several sets or folds share",
                  "they are solved once at a wavelength");
}

}  // namespace gonio
