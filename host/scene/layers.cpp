// SPDX-License-Identifier: Apache-2.0
// Reads layers of a material: coefficients in 1/cm, thickness in cm.
#include <limits>

#include "scene/material.hpp"
#include "scene/sweep.hpp"

namespace gonio {
namespace {

std::vector<double> list_or_empty(const Section& section, std::string_view key)
{
    const auto value = section.find(key);
    return value ? value->numbers() : std::vector<double>();
}

/// Reads the numbers of one layer; those that are not there keep what they are.
class LayerReader {
public:
    LayerReader(const Section& section, std::size_t part, std::vector<Sweep>& sweeps)
        : section_(section), part_(part), sweeps_(sweeps)
    {
    }

    Layer read()
    {
        Layer layer;
        layer.phase = phase();
        number("mua", layer.mua);
        number("mus", layer.mus);
        number("n", layer.n);
        if (const auto d = section_.find("d")) layer.d = thickness(*d);
        return layer;
    }

private:
    void number(std::string_view key, double& to)
    {
        if (const auto value = section_.find(key)) to = read_swept_number(*value, part_, sweeps_);
    }

    double thickness(const Value& value)
    {
        if (value.is_table()) return read_swept_number(value, part_, sweeps_);
        return value.number(0, std::numeric_limits<double>::infinity());
    }

    /// The keys of a layer depend on its phase function.
    void allow(std::vector<std::string_view> more) const
    {
        more.insert(more.begin(), {"mua", "mus", "n", "d", "phase"});
        section_.allow(more);
    }

    PhaseFunction phase()
    {
        const auto kind = section_.find("phase");
        switch (kind ? kind->choice(
                           {"henyey_greenstein", "isotropic", "rayleigh", "two_term", "tabulated"})
                     : 0) {
            case 0: {
                allow({"g"});
                HenyeyGreenstein phase;
                number("g", phase.g);
                return phase;
            }
            case 1:
                allow({});
                return Isotropic{};
            case 2:
                allow({});
                return Rayleigh{};
            case 3: {
                allow({"g_1", "g_2", "weight_1"});
                TwoTermHenyeyGreenstein phase;
                number("g_1", phase.g_1);
                number("g_2", phase.g_2);
                number("weight_1", phase.weight_1);
                return phase;
            }
            default:
                allow({"cosine", "value"});
                return TabulatedPhase{list_or_empty(section_, "cosine"),
                                      list_or_empty(section_, "value")};
        }
    }

    const Section& section_;
    std::size_t part_;
    std::vector<Sweep>& sweeps_;
};

}  // namespace

LayeredMedium read_layers(const Section& material, std::vector<Sweep>& sweeps)
{
    LayeredMedium medium;
    const Value layers = material.at("layers");
    for (const Value& layer : layers.list())
        medium.layers.push_back(LayerReader(Section(layer), medium.layers.size(), sweeps).read());
    if (const auto n = material.find("n_above")) medium.n_above = n->number();
    if (const auto n = material.find("n_below")) medium.n_below = n->number();
    if (const auto bottom = material.find("bottom"))
        medium.bottom =
            std::vector{Bottom::open, Bottom::black, Bottom::mirror,
                        Bottom::diffuse}[bottom->choice({"open", "black", "mirror", "diffuse"})];
    if (const auto albedo = material.find("bottom_albedo")) medium.bottom_albedo = albedo->number();
    located(layers.where(), [&] { validate(medium); });
    return medium;
}

}  // namespace gonio
