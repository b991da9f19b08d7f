// SPDX-License-Identifier: Apache-2.0
// Layers and light as the numbers that the photon kernel reads.
#include "photon/layer_records.hpp"

#include <cmath>

#include "gonio/shared/photon_fields.h"
#include "photon/phase_segments.hpp"

namespace gonio {
namespace {

constexpr double no_matter = 1e30;   // a free path that always ends at a boundary, cm
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

/// How far apart the layers of a spectrum are: vectors of every width may read to the end.
std::size_t spectrum_stride(const PhotonTallies& tallies)
{
    constexpr std::size_t widest = 16;
    return (tallies.spectrum.size() + widest - 1) / widest * widest;
}

}  // namespace

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

void add_spectrum(PhotonProgram& program, const PhotonTallies& tallies, std::size_t layers)
{
    const std::size_t first = program.layers.size(), stride = spectrum_stride(tallies);
    program.layers.resize(first + layers * stride);
    for (std::size_t k = 0; k < tallies.spectrum.size(); ++k)
        for (std::size_t layer = 0; layer < layers; ++layer)
            program.layers[first + layer * stride + k] =
                static_cast<float>(tallies.spectrum[k][layer]);
}

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

}  // namespace gonio
