// SPDX-License-Identifier: Apache-2.0
// From a medium to definitions and numbers of the photon kernel.
#include "photon/program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gonio/errors.hpp"
#include "gonio/shared/photon_fields.h"
#include "photon/phase_segments.hpp"

namespace gonio {
namespace {

constexpr double no_matter = 1e30;  // a free path that always ends at a boundary, cm
constexpr double cm_per_ps = 0.0299792458;
constexpr double everything = 1.01;  // of a weight, also after rounding; no more than all is taken

/// Writes a phase function into the record of a layer.
struct PhaseFields {
    float* record;
    std::vector<float>& segments;

    void operator()(const HenyeyGreenstein& phase) const { terms(phase.g, 0, 1); }
    void operator()(const Isotropic&) const { terms(0, 0, 1); }
    void operator()(const Rayleigh&) const
    {
        terms(0, 0, 1);
        record[layer_rayleigh] = 1;
    }
    void operator()(const TwoTermHenyeyGreenstein& phase) const
    {
        terms(phase.g_1, phase.g_2, phase.weight_1);
    }
    void operator()(const TabulatedPhase& phase) const
    {
        terms(0, 0, 1);
        const std::vector<float> records = phase_segments(phase);
        const std::size_t first = segments.size() / segment_fields;
        const std::size_t count = records.size() / segment_fields;
        record[layer_first_segment] = static_cast<float>(first);
        record[layer_segments] = static_cast<float>(count);
        segments.insert(segments.end(), records.begin(), records.end());
    }

    void terms(double g_1, double g_2, double weight_1) const
    {
        record[layer_g_1] = static_cast<float>(g_1);
        record[layer_g_2] = static_cast<float>(g_2);
        record[layer_weight_1] = static_cast<float>(weight_1);
    }
};

/// Fills the program's records of layers and of their tabulated phase functions.
void add_layers(PhotonProgram& program, const LayeredMedium& medium)
{
    const std::size_t count = medium.layers.size();
    program.layers.resize(count * layer_fields);
    double top = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const Layer& layer = medium.layers[k];
        float* record = &program.layers[k * layer_fields];
        const double met = layer.mua + layer.mus;
        const double up = layer.n / (k == 0 ? medium.n_above : medium.layers[k - 1].n);
        const double down = layer.n / (k + 1 == count ? medium.n_below : medium.layers[k + 1].n);
        const auto set = [&](layer_field field, double value) {
            record[field] = static_cast<float>(value);
        };
        set(layer_mean_free_path, met > 1 / no_matter ? 1 / met : no_matter);
        set(layer_absorbed, layer.mus == 0 ? everything : layer.mua / met);
        set(layer_thickness, layer.d);
        set(layer_top, top);
        set(layer_index, layer.n);
        set(layer_ratio_up, up);
        set(layer_excess_up, (1 - up) * (1 + up));
        set(layer_ratio_down, down);
        set(layer_excess_down, (1 - down) * (1 + down));
        std::visit(PhaseFields{record, program.phases}, layer.phase);
        top += layer.d;
    }
    if (program.phases.empty()) program.phases.resize(segment_fields);  // no buffer has no bytes
}

/// How far apart the layers of a spectrum are: vectors of every width may read to the end.
std::size_t spectrum_stride(const PhotonTallies& tallies)
{
    constexpr std::size_t widest = 16;
    return (tallies.spectrum.size() + widest - 1) / widest * widest;
}

void add_spectrum(PhotonProgram& program, const PhotonTallies& tallies, std::size_t layers)
{
    const std::size_t first = program.layers.size(), stride = spectrum_stride(tallies);
    program.layers.resize(first + layers * stride);
    for (std::size_t k = 0; k < tallies.spectrum.size(); ++k)
        for (std::size_t layer = 0; layer < layers; ++layer)
            program.layers[first + layer * stride + k] =
                static_cast<float>(tallies.spectrum[k][layer]);
}

/// Refraction at the first boundary: Born and Wolf 1.5.2.
KernelSource refracted_beam(const LayeredMedium& medium, const LightSource& light)
{
    const double incidence = light.beam == Beam::diffuse ? 0 : light.incidence;
    const double ratio = medium.n_above / medium.layers.front().n, cosine = std::cos(incidence);
    const double sine = ratio * std::sin(incidence);
    const double excess = (1 - ratio) * (1 + ratio);
    KernelSource source{static_cast<float>(sine), 0, 0, static_cast<float>(ratio),
                        static_cast<float>(excess)};
    source.radius_x = static_cast<float>(light.radius / cosine);
    source.radius_y = static_cast<float>(light.radius);
    if (sine >= 1) return source;
    const double behind = std::sqrt((1 - sine) * (1 + sine));
    const double s = (ratio * cosine - behind) / (ratio * cosine + behind);
    const double p = (ratio * behind - cosine) / (ratio * behind + cosine);
    source.cosine = static_cast<float>(behind);
    source.weight =
        static_cast<std::uint32_t>(std::lround((1 - (s * s + p * p) / 2) * whole_photon));
    return source;
}

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
    program.source = refracted_beam(medium, request.light);
    if (medium.bottom == Bottom::diffuse)
        program.bottom_albedo = static_cast<float>(medium.bottom_albedo);
    program.row_bins_per_unit = static_cast<float>(row_bins_per_unit(tallies));
    program.radius_bins_per_cm = static_cast<float>(1 / tallies.radius_width);
    program.depth_bins_per_cm = static_cast<float>(1 / tallies.depth_width);
    program.reflected = photon_totals + medium.layers.size();
    program.transmitted = program.reflected + (tallies.reflected ? tallies.exit_bins() : 0);
    program.absorbed = program.transmitted + (tallies.transmitted ? tallies.exit_bins() : 0);
    program.spectrum = program.absorbed + (tallies.absorbed ? tallies.absorbed_bins() : 0);
    const std::size_t wavelengths = program.wavelengths = tallies.spectrum.size();
    program.sums = program.spectrum + (tallies.rows + 3) * wavelengths;

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
    if (wavelengths > 0) {
        define("SPECTRUM", 1);
        define("SPECTRUM_ROWS", tallies.rows + 1);
        define("FIRST_SPECTRUM", program.spectrum);
    }
    return program;
}

}  // namespace gonio
