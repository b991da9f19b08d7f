// SPDX-License-Identifier: Apache-2.0
// Combines ladders to sets of parameters and writes spectra into a table.
#include "skin/skin_sets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "gonio/colour.hpp"
#include "gonio/quantity.hpp"
#include "version.hpp"

namespace gonio {
namespace {

std::string with_unit(const SkinParameter& parameter, double value)
{
    const bool plain = parameter.unit == "1";
    return fmt::format("{} {:.6g}{}{}", parameter.name, value, plain ? "" : " ",
                       plain ? "" : parameter.unit);
}

bool is_ladder(const SkinTask& task, const std::string& parameter)
{
    return std::ranges::find(task.ladders, parameter, &SkinLadder::parameter) != task.ladders.end();
}

using Attributes = std::vector<std::pair<std::string, Attribute>>;

void add_colours(Attributes& all, const std::vector<SkinSpectrum>& spectra)
{
    std::vector<double> xyz, linear, lab, angle;
    const auto append = [](std::vector<double>& to, const glm::dvec3& numbers) {
        to.insert(to.end(), {numbers.x, numbers.y, numbers.z});
    };
    for (const SkinSpectrum& spectrum : spectra) {
        const auto colour = colour_of(spectrum.wavelengths, spectrum.reflectance);
        append(xyz, colour.xyz);
        append(linear, colour.linear);
        append(lab, colour.lab);
        angle.push_back(colour.typology_angle);
    }
    all.emplace_back("colour.observer", std::string("CIE 1931 2 deg, D65"));
    all.emplace_back("colour.XYZ", xyz);
    all.emplace_back("colour.linear_sRGB", linear);
    all.emplace_back("colour.Lab", lab);
    all.emplace_back("colour.ITA", angle);
    all.emplace_back("colour.ITA.unit", std::string("deg"));
}

void add_solver(Attributes& all, const SkinTask& task)
{
    all.emplace_back("solver", std::string("adding_doubling"));
    all.emplace_back("max_error", task.tolerance);
    all.emplace_back("light", std::string(task.light.beam == Beam::diffuse ? "diffuse" : "beam"));
    if (task.light.beam == Beam::diffuse) return;
    all.emplace_back("theta_i", task.light.incidence * 180 / std::numbers::pi);
    all.emplace_back("theta_i.unit", std::string("deg"));
}

std::vector<std::string> channels_of(const Quantity& quantity, std::size_t layers)
{
    if (quantity.id == "transmittance_d") return {"Y", "Y.error"};
    if (quantity.id == "colour_xyz") return {"X", "Y", "Z"};
    if (quantity.id != "reflectance_spectrum") return {"R", "G", "B"};
    std::vector<std::string> names{"reflectance", "specular", "transmittance", "bottom"};
    for (std::size_t k = 1; k <= layers; ++k) names.push_back(fmt::format("layer_{}", k));
    names.emplace_back("reflectance.error");
    return names;
}

}  // namespace

std::vector<Skin> sets_of(const SkinTask& task)
{
    std::vector<Skin> sets{task.skin};
    for (const SkinLadder& ladder : task.ladders) {
        std::vector<Skin> more;
        for (const Skin& set : sets)
            for (const double value : ladder.values) {
                more.push_back(set);
                more.back().set(ladder.parameter, value);
            }
        sets = std::move(more);
    }
    return sets;
}

std::vector<double> default_wavelengths()
{
    std::vector<double> all;
    for (int wavelength = 380; wavelength <= 780; wavelength += 5) all.push_back(wavelength);
    return all;
}

std::string label_of(const SkinTask& task, const Skin& set)
{
    std::string text;
    for (const SkinLadder& ladder : task.ladders) {
        const std::size_t index = set.model().index_of(ladder.parameter);
        text += fmt::format("{}{}", text.empty() ? "" : ", ",
                            with_unit(set.model().parameters[index], set.values()[index]));
    }
    return text;
}

std::string fixed_text(const SkinTask& task)
{
    std::string text;
    const auto& parameters = task.skin.model().parameters;
    for (std::size_t k = 0; k < parameters.size(); ++k)
        if (!is_ladder(task, parameters[k].name))
            text += fmt::format("{}{}", text.empty() ? "" : ", ",
                                with_unit(parameters[k], task.skin.values()[k]));
    return text;
}

TableHeader sets_header(const SkinTask& task, const Quantity& quantity)
{
    const SkinModel& model = task.skin.model();
    TableHeader header;
    header.quantity = quantity.id;
    header.unit = quantity.unit;
    header.single_precision = false;
    header.attributes.emplace_back("program", std::string(GONIO_PROGRAM));
    header.attributes.emplace_back("skin", model.id);
    header.attributes.emplace_back("citation", model.citation);
    for (std::size_t k = 0; k < model.parameters.size(); ++k) {
        const auto& [name, unit, least, greatest, preset, doc] = model.parameters[k];
        if (is_ladder(task, name)) continue;
        header.attributes.emplace_back(name, task.skin.values()[k]);
        if (unit != "1") header.attributes.emplace_back(name + ".unit", unit);
    }
    for (std::size_t k = 0; k < model.layers.size(); ++k)
        header.attributes.emplace_back(fmt::format("layer_{}", k + 1), model.layers[k]);
    for (const SkinLadder& ladder : task.ladders) {
        const std::string& unit = model.parameters[model.index_of(ladder.parameter)].unit;
        header.axes.push_back({ladder.parameter, unit, ladder.values, Samples::node});
    }
    return header;
}

std::vector<double> wavelengths_of(const TableRequest& request)
{
    const auto& axes = request.axes;
    return !axes.empty() && axes[0].name == "wavelength" ? axes[0].values : default_wavelengths();
}

TableHeader skin_header(const SkinTask& task, const Quantity& quantity,
                        const std::vector<Axis>& own)
{
    TableHeader header = sets_header(task, quantity);
    add_solver(header.attributes, task);
    header.axes.insert(header.axes.end(), own.begin(), own.end());
    header.channels = channels_of(quantity, task.skin.model().layers.size());
    return header;
}

std::vector<std::vector<double>> spectrum_channels(const std::vector<SkinSpectrum>& spectra)
{
    std::vector<std::vector<double>> channels;
    for (const SkinSpectrum& spectrum : spectra) {
        std::vector<const std::vector<double>*> planes{&spectrum.reflectance, &spectrum.specular,
                                                       &spectrum.transmittance, &spectrum.bottom};
        for (const auto& layer : spectrum.absorption) planes.push_back(&layer);
        const std::vector<double> error(spectrum.wavelengths.size(), spectrum.error);
        planes.push_back(&error);
        channels.resize(planes.size());
        for (std::size_t c = 0; c < planes.size(); ++c)
            channels[c].insert(channels[c].end(), planes[c]->begin(), planes[c]->end());
    }
    return channels;
}

Table spectrum_table(const SkinTask& task, const std::vector<SkinSpectrum>& spectra)
{
    const Quantity& quantity = find_quantity("reflectance_spectrum", Substance::skin);
    const Axis wavelengths{"wavelength", "nm", task.wavelengths, Samples::node};
    Table table{skin_header(task, quantity, {wavelengths}), spectrum_channels(spectra)};
    if (has_colour(task.wavelengths)) add_colours(table.header.attributes, spectra);
    return table;
}

}  // namespace gonio
