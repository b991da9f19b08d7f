// SPDX-License-Identifier: Apache-2.0
// Reads materials: a model, a sum of lobes, layers or skin.
#include "scene/material.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "scene/lobe.hpp"
#include "scene/sweep.hpp"

namespace gonio {
namespace {

constexpr std::size_t max_name = 100;  // bytes, so that file names with sweeps stay below 255

std::vector<Lobe> read_lobes(const Value& list, std::vector<Sweep>& sweeps)
{
    std::vector<Lobe> lobes;
    for (const Value& value : list.list()) {
        const Section section(value);
        section.allow({"model", "weight", "parameters"});
        lobes.push_back(read_lobe(section, lobes.size(), sweeps));
    }
    if (lobes.empty()) list.fail("a sum of no lobes; allowed is at least one");
    return lobes;
}

/// `diffuse` and `specular`, the components of Phong's shading by name.
std::vector<Lobe> read_components(const Section& material, std::vector<Sweep>& sweeps)
{
    std::vector<Lobe> lobes;
    for (const auto name : {"diffuse", "specular"}) {
        const auto component = material.find(name);
        if (!component) continue;
        const Section section(*component);
        section.allow({"model", "weight", "parameters"});
        lobes.push_back(read_lobe(section, lobes.size(), sweeps));
    }
    return lobes;
}

/// Of layers: one lobe.
Lobe read_surface(const Value& value)
{
    const Section section(value);
    section.allow({"model", "weight", "parameters"});
    std::vector<Sweep> sweeps;
    Lobe lobe = read_lobe(section, 0, sweeps);
    if (!sweeps.empty())
        throw UsageError(sweeps.front().where + "the surface of layers has no sweeps");
    return lobe;
}

/// One number or one per channel of the material.
std::vector<double> read_ambient(const Value& value, std::size_t channels)
{
    auto numbers = value.is_list() ? value.numbers() : std::vector{value.number()};
    for (const double number : numbers)
        if (!(number >= 0 && number <= 1e6))
            value.fail(fmt::format("`ambient` is {}; allowed is a radiance of 0 to 1e6", number));
    if (numbers.size() != 1 && numbers.size() != channels)
        value.fail(
            fmt::format("`ambient` has {} numbers; allowed is one, or one for each of {} "
                        "channels",
                        numbers.size(), channels));
    return numbers;
}

/// "model", "lobes", "diffuse" (or specular, or both), "layers" or "skin": which the material has.
std::string_view kind_of(const Section& section)
{
    section.allow({"name", "model", "weight", "parameters", "lobes", "diffuse", "specular",
                   "ambient", "surface", "layers", "n_above", "n_below", "bottom", "bottom_albedo",
                   "skin", "wavelength"});
    std::vector<std::string_view> kinds;
    for (const auto kind : {"model", "lobes", "diffuse", "specular", "layers", "skin"})
        if (section.find(kind)) kinds.emplace_back(kind);
    if (kinds == std::vector<std::string_view>{"diffuse", "specular"}) kinds.pop_back();
    if (kinds.size() != 1)
        section.fail(fmt::format(
            "a material is one of `model`, `lobes`, `diffuse` with `specular`, `layers` and "
            "`skin`, {}",
            kinds.empty() ? "and this one has none of them"
                          : fmt::format("not `{}`", fmt::join(kinds, "` and `"))));
    return kinds.front();
}

}  // namespace

std::string read_name(const Value& value)
{
    auto name = value.text();
    const bool unprintable =
        std::ranges::any_of(name, [](unsigned char c) { return c < 0x20 || c == 0x7f; });
    if (name.empty() || name.size() > max_name || name.front() == '.' || unprintable ||
        name.find('/') != std::string::npos) {
        value.fail(
            fmt::format("`{}` is part of a file's name: allowed are 1 to {} bytes without / "
                        "and control characters, not beginning with a dot",
                        value.name(), max_name));
    }
    return name;
}

std::size_t find_material(const Value& value, const std::vector<SceneMaterial>& materials)
{
    const auto name = value.text();
    const auto found = std::ranges::find(materials, name, &SceneMaterial::name);
    if (found != materials.end()) return static_cast<std::size_t>(found - materials.begin());
    std::vector<std::string_view> names;
    for (const SceneMaterial& material : materials) names.push_back(material.name);
    value.fail(fmt::format("there is no material `{}`{}", name, suggestion(name, names)));
}

SceneMaterial read_material(const Value& value)
{
    const Section section(value);
    const auto kind = kind_of(section);
    SceneMaterial material;
    material.where = section.where();
    material.name = read_name(section.at("name"));
    if (kind == "model") {
        section.allow({"name", "model", "weight", "parameters", "ambient"});
        material.made_of = std::vector{read_lobe(section, 0, material.sweeps)};
    } else if (kind == "lobes") {
        section.allow({"name", "lobes", "ambient"});
        material.made_of = read_lobes(section.at("lobes"), material.sweeps);
    } else if (kind == "diffuse" || kind == "specular") {
        section.allow({"name", "diffuse", "specular", "ambient"});
        material.made_of = read_components(section, material.sweeps);
    } else if (kind == "layers") {
        section.allow(
            {"name", "layers", "n_above", "n_below", "bottom", "bottom_albedo", "surface"});
        material.made_of = read_layers(section, material.sweeps);
    } else {
        section.allow({"name", "skin", "parameters", "wavelength", "surface"});
        if (section.find("wavelength"))
            material.made_of = read_skin_layers(section);
        else
            material.made_of = read_skin(section, material.sweeps);
    }
    if (const auto surface = section.find("surface")) material.surface = read_surface(*surface);
    if (const auto* lobes = std::get_if<std::vector<Lobe>>(&material.made_of)) {
        const auto channels = located(material.where, [&] {
            return Material{material.name, *lobes}.channels();
        });
        if (const auto ambient = section.find("ambient"))
            material.ambient = read_ambient(*ambient, channels);
    }
    return material;
}

}  // namespace gonio
