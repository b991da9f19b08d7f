// SPDX-License-Identifier: Apache-2.0
// From a medium to definitions and numbers of the photon kernel.
#include "photon/program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gonio/errors.hpp"
#include "gonio/shared/photon_fields.h"
#include "photon/layer_records.hpp"

namespace gonio {
namespace {

constexpr double cm_per_ps = 0.0299792458;

template <class Phase>
bool has_phase(const LayeredMedium& medium)
{
    return std::ranges::any_of(medium.layers, [](const Layer& layer) {
        return std::holds_alternative<Phase>(layer.phase);
    });
}

void check(const PhotonRequest& request)
{
    if (!(request.light.incidence >= 0 && request.light.incidence < std::numbers::pi / 2))
        throw UsageError(fmt::format("an angle of incidence of {} degrees must be in [0, 90)",
                                     request.light.incidence * 180 / std::numbers::pi));
    if (!(request.roulette_below > 0 && request.roulette_below <= 0.125))
        throw UsageError(
            fmt::format("roulette below a weight of {} must be above 0 and at most 1/8",
                        request.roulette_below));
    if (!(request.light.radius >= 0 && std::isfinite(request.light.radius)))
        throw UsageError(
            fmt::format("a beam's radius of {} cm must be 0 or more", request.light.radius));
}

void check_spectrum(const PhotonTallies& tallies, std::size_t layers)
{
    if (tallies.spectrum.empty()) return;
    if (tallies.row != ExitRow::radius) throw UsageError("the rows of a spectrum are radii");
    for (const std::vector<double>& wavelength : tallies.spectrum)
        if (wavelength.size() != layers || !std::ranges::all_of(wavelength, [](double more) {
                return more >= 0 && std::isfinite(more);
            }))
            throw UsageError(fmt::format(
                "a spectrum needs {} numbers of absorption, at least 0, for each wavelength",
                layers));
}

double row_bins_per_unit(const PhotonTallies& tallies)
{
    switch (tallies.row) {
        case ExitRow::radius:
            return 1 / tallies.radius_width;
        case ExitRow::azimuth:
            return static_cast<double>(tallies.rows) / std::numbers::pi;
        default:
            return 1 / (tallies.time_width * cm_per_ps);
    }
}

/// Where each tally begins among the sums.
void place_sums(PhotonProgram& program, const PhotonTallies& tallies, std::size_t layers)
{
    program.reflected = photon_totals + layers;
    program.transmitted = program.reflected + (tallies.reflected ? tallies.exit_bins() : 0);
    program.absorbed = program.transmitted + (tallies.transmitted ? tallies.exit_bins() : 0);
    program.spectrum = program.absorbed + (tallies.absorbed ? tallies.absorbed_bins() : 0);
    program.wavelengths = tallies.spectrum.size();
    program.sums = program.spectrum + (tallies.rows + 3) * program.wavelengths;
}

/// All that is compiled in.
void define_all(PhotonProgram& program, const LayeredMedium& medium, const PhotonRequest& request)
{
    const PhotonTallies& tallies = request.tallies;
    const Layer& top = medium.layers.front();
    program.preamble = "#define EACH_LAYER(DO)";
    for (std::size_t k = 0; k < medium.layers.size(); ++k)
        program.preamble += fmt::format(" DO({})", k);
    program.preamble += '\n';
    const auto define = [&](std::string_view name, std::size_t value) {
        program.definitions.push_back(fmt::format("{}={}", name, value));
    };
    define("LAYERS", medium.layers.size());
    define("BOTTOM", medium.bottom == Bottom::open ? 0 : medium.bottom == Bottom::mirror ? 1 : 2);
    define("SOURCE", static_cast<std::size_t>(request.light.beam));
    define("CLEAR_TOP", top.mua + top.mus == 0 ? 1 : 0);
    define("TWO_TERMS", has_phase<TwoTermHenyeyGreenstein>(medium) ? 1 : 0);
    define("RAYLEIGH", has_phase<Rayleigh>(medium) ? 1 : 0);
    define("TABULATED", has_phase<TabulatedPhase>(medium) ? 1 : 0);
    define("ROULETTE_BELOW",
           static_cast<std::size_t>(std::lround(request.roulette_below * whole_photon)));
    define("REFLECTED", tallies.reflected ? 1 : 0);
    define("TRANSMITTED", tallies.transmitted ? 1 : 0);
    define("ABSORBED", tallies.absorbed ? 1 : 0);
    if (tallies.reflected || tallies.transmitted) {
        define("ROW", static_cast<std::size_t>(tallies.row));
        define("ROWS", tallies.rows);
        define("ANGLES", tallies.angles);
        define("FIRST_REFLECTED", program.reflected);
        define("FIRST_TRANSMITTED", program.transmitted);
    }
    if (tallies.absorbed) {
        define("DEPTH_BINS", tallies.depths);
        define("ABSORBED_RADIUS_BINS", tallies.absorbed_radii);
        define("FIRST_ABSORBED", program.absorbed);
    }
    if (program.wavelengths > 0) {
        define("SPECTRUM", 1);
        define("SPECTRUM_ROWS", tallies.rows + 1);
        define("FIRST_SPECTRUM", program.spectrum);
    }
}

}  // namespace

PhotonProgram photon_program(const LayeredMedium& medium, const PhotonRequest& request)
{
    validate(medium);
    check(request);
    const PhotonTallies& tallies = request.tallies;
    check_spectrum(tallies, medium.layers.size());
    PhotonProgram program;
    add_layers(program, medium);
    add_spectrum(program, tallies, medium.layers.size());
    place_sums(program, tallies, medium.layers.size());
    program.source = refracted_beam(medium, request.light);
    if (medium.bottom == Bottom::diffuse)
        program.bottom_albedo = static_cast<float>(medium.bottom_albedo);
    program.row_bins_per_unit = static_cast<float>(row_bins_per_unit(tallies));
    program.radius_bins_per_cm = static_cast<float>(1 / tallies.radius_width);
    program.depth_bins_per_cm = static_cast<float>(1 / tallies.depth_width);
    define_all(program, medium, request);
    return program;
}

}  // namespace gonio
