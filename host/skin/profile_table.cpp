// SPDX-License-Identifier: Apache-2.0
// From a job to its table of light that spreads in skin.
#include "skin/profile_table.hpp"

#include "photon/bins.hpp"
#include "photon/simulation.hpp"
#include "scene/located.hpp"
#include "skin/radial_table.hpp"
#include "skin/skin_sets.hpp"
#include "skin/traced_sets.hpp"

namespace gonio {
namespace {

constexpr std::uint64_t most_photons = std::uint64_t{1} << 48;  // numbers that a base has

nlohmann::ordered_json fits_of(const ProfileFit<SumOfGaussians>& gaussians,
                               const RadialProfile& profile)
{
    const auto burley = fit_burley(profile);
    return {{"photons", profile.photons},
            {"gaussians",
             {{"variance_mm2", gaussians.function.variances},
              {"weight_rgb", gaussians.function.weights},
              {"error_rgb", gaussians.error}}},
            {"burley",
             {{"albedo_rgb", burley.function.albedo},
              {"distance_mm_rgb", burley.function.distance},
              {"error_rgb", burley.error}}}};
}

/// Per area of the rings, and the errors behind.
void append_rings(Table& table, const RadialProfile& profile)
{
    for (std::size_t c = 0; c < 3; ++c)
        for (const Fraction& ring : ring_densities(profile.rings[c], profile.width)) {
            table.values[c].push_back(ring.mean);
            table.values[c + 3].push_back(ring.error);
        }
}

void append_sphere(Table& table, const SumOfGaussians& profile, const Axis& cosines,
                   const Axis& curvatures)
{
    for (const double cosine : cosines.values)
        for (const double curvature : curvatures.values) {
            const auto light = around_a_sphere(profile, cosine, curvature);
            for (std::size_t c = 0; c < 3; ++c) table.values[c].push_back(light[c]);
        }
}

/// The largest of all channels and sets, and what it is a part of.
void tell_error(nlohmann::ordered_json& run, const Job& job, const Table& table)
{
    double largest = 0;
    const std::size_t rings = job.header.row_length();
    if (job.header.quantity == "profile_rgb") {
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t k = 0; k < table.values[c].size(); k += rings) {
                std::vector<Fraction> densities;
                for (std::size_t ring = k; ring < k + rings; ++ring)
                    densities.push_back({table.values[c][ring], table.values[c + 3][ring]});
                largest = std::max(largest, largest_error(densities));
            }
        run["error_of"] = "a channel's largest value";
    } else {
        for (const auto& fit : run.at("fits"))
            for (const double error : fit.at("gaussians").at("error_rgb"))
                largest = std::max(largest, error);
        run["error_of"] = "the profile, by Gaussians";
    }
    run["error"] = largest;
}

nlohmann::ordered_json make_colour_table(const Device& device, const Job& job,
                                         const std::function<void(double)>& after_each)
{
    const auto trace = [&](const Skin& set, Table& table, const nlohmann::ordered_json& from,
                           const AfterLaunch& after_launch) {
        const auto profile = trace_profile(device, bands_of(set), *job.profile, from, after_launch);
        const auto gaussians = fit_gaussians(profile);
        if (job.header.quantity == "profile_rgb")
            append_rings(table, profile);
        else
            append_sphere(table, gaussians.function, *(job.header.axes.end() - 2),
                          job.header.axes.back());
        return fits_of(gaussians, profile);
    };
    const TracedSets traced = trace_sets(job, after_each, trace);
    write_table(job.path, job.format, traced.table, job.write);
    std::uint64_t photons = UINT64_MAX;  // of each set, at least
    for (const auto& fit : traced.beside)
        photons = std::min(photons, fit.at("photons").get<std::uint64_t>());
    nlohmann::ordered_json run{{"photons", photons}, {"fits", traced.beside}};
    tell_error(run, job, traced.table);
    return run;
}

}  // namespace

ProfileRequest profile_request(const TableRequest& request)
{
    ProfileRequest wanted{.seed = request.seed};
    wanted.photons = request.budget.photons.value_or(wanted.photons);
    wanted.max_error = request.budget.max_error;
    wanted.ring_error = request.budget.ring_error;
    wanted.seconds = request.budget.seconds;
    const bool open_ended = wanted.max_error || wanted.ring_error || wanted.seconds;
    if (open_ended && !request.budget.photons) wanted.photons = most_photons;
    if (request.quantity->id != "preintegrated_rgb") {
        const Axis& rings = request.axes.back();
        wanted.rings = rings.values.size();
        wanted.width = 2 * rings.values.front();
    }
    return wanted;
}

TableHeader profile_header(const SkinTask& task, const TableRequest& request)
{
    TableHeader header = sets_header(task, *request.quantity);
    header.axes.insert(header.axes.end(), request.axes.begin(), request.axes.end());
    const bool spectrum = request.quantity->id == "reflectance_r";
    header.channels = {"R", "G", "B"};
    if (spectrum) header.channels = {"Y", "Y.error"};
    if (request.quantity->id == "profile_rgb")
        for (const auto name : {"R.error", "G.error", "B.error"})
            header.channels.emplace_back(name);
    const ProfileRequest wanted = profile_request(request);
    auto& all = header.attributes;
    all.emplace_back("solver", request.solver);
    if (wanted.photons < most_photons)
        all.emplace_back("photons", static_cast<double>(wanted.photons));
    if (wanted.max_error) all.emplace_back("max_error", *wanted.max_error);
    if (wanted.ring_error) all.emplace_back("ring_error", *wanted.ring_error);
    if (wanted.seconds) {
        all.emplace_back("time", *wanted.seconds);
        all.emplace_back("time.unit", std::string("s"));
    }
    all.emplace_back("seed", static_cast<double>(wanted.seed));
    if (spectrum) return header;
    all.emplace_back("colour.observer", std::string("CIE 1931 2 deg, D65, every 20 nm"));
    return header;
}

nlohmann::ordered_json make_profile_table(const Device& device, const Job& job,
                                          const std::function<void(double)>& after_each)
{
    return located(job.where, [&] {
        auto run = job.header.quantity == "reflectance_r"
                       ? make_radial_table(device, job, after_each)
                       : make_colour_table(device, job, after_each);
        forget_simulation(job);
        return run;
    });
}

}  // namespace gonio
