// SPDX-License-Identifier: Apache-2.0
// Text and JSON of spectra and colours.
#include "commands/skin_report.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <numbers>

#include "gonio/colour.hpp"

namespace gonio {
namespace {

constexpr double degrees = 180 / std::numbers::pi;

std::string light_text(const LightSource& light)
{
    return light.beam == Beam::diffuse
               ? "diffuse light"
               : fmt::format("beam at {:.4g} deg", light.incidence * degrees);
}

/// A row of text: a name, then a number for each set.
template <class Number>
void print_row(const std::string& name, const std::string& format,
               const std::vector<SkinSpectrum>& spectra, const Number& number)
{
    fmt::print("{:<16}", name);
    for (const SkinSpectrum& spectrum : spectra)
        fmt::print("{:>12}", fmt::format(fmt::runtime(format), number(spectrum)));
    fmt::print("\n");
}

void print_colours(const std::vector<SkinSpectrum>& spectra)
{
    const auto colour = [](const SkinSpectrum& spectrum) {
        return colour_of(spectrum.wavelengths, spectrum.reflectance);
    };
    const char* const xyz[] = {"X", "Y", "Z"};
    const char* const lab[] = {"L*", "a*", "b*"};
    for (int c = 0; c < 3; ++c)
        print_row(xyz[c], "{:.2f}", spectra, [&](const auto& s) { return colour(s).xyz[c]; });
    for (int c = 0; c < 3; ++c)
        print_row(lab[c], "{:.2f}", spectra, [&](const auto& s) { return colour(s).lab[c]; });
    print_row("ITA [deg]", "{:.1f}", spectra,
              [&](const auto& s) { return colour(s).typology_angle; });
    const char* const linear[] = {"linear R", "linear G", "linear B"};
    for (int c = 0; c < 3; ++c)
        print_row(linear[c], "{:.4f}", spectra, [&](const auto& s) { return colour(s).linear[c]; });
    print_row("sRGB", "{}", spectra, [&](const auto& s) {
        const auto bytes = colour(s).srgb;
        return fmt::format("#{:02x}{:02x}{:02x}", bytes.x, bytes.y, bytes.z);
    });
    if (isatty(STDOUT_FILENO) == 0 || std::getenv("NO_COLOR")) return;
    print_row("", "{}", spectra, [&](const auto& s) {
        const auto bytes = colour(s).srgb;
        return fmt::format("  \x1b[48;2;{};{};{}m{:10}\x1b[0m", bytes.x, bytes.y, bytes.z, "");
    });
}

}  // namespace

void print_spectra(const SkinTask& task, const std::vector<Skin>& sets,
                   const std::vector<SkinSpectrum>& spectra)
{
    const SkinModel& model = task.skin.model();
    fmt::print("{}: {}\n", model.id, model.title);
    if (const std::string fixed = fixed_text(task); !fixed.empty()) fmt::print("{}\n", fixed);
    fmt::print("{}; reflectance includes what the surface reflects\n\n", light_text(task.light));
    for (const SkinLadder& ladder : task.ladders) {
        fmt::print("{:<16}", ladder.parameter);
        for (const Skin& set : sets)
            fmt::print("{:>12.6g}", set.values()[model.index_of(ladder.parameter)]);
        fmt::print("\n");
    }
    fmt::print("{:<16}", "wavelength [nm]");
    for (std::size_t k = 0; k < sets.size(); ++k) fmt::print("{:>12}", "reflectance");
    fmt::print("\n");
    for (std::size_t k = 0; k < task.wavelengths.size(); ++k)
        print_row(fmt::format("{}", task.wavelengths[k]), "{:.5f}", spectra,
                  [k](const auto& s) { return s.reflectance[k]; });
    fmt::print("\n");
    print_row("surface, of it", "{:.5f}", spectra,
              [](const auto& s) { return *std::ranges::max_element(s.specular); });
    print_row("error up to", "{:.1e}", spectra, [](const auto& s) { return s.error; });
    if (has_colour(task.wavelengths))
        print_colours(spectra);
    else
        fmt::print(stderr, "no colour: that needs 380 to 780 nm in steps of up to 20 nm\n");
}

void print_spectra_json(const SkinTask& task, const std::vector<Skin>& sets,
                        const std::vector<SkinSpectrum>& spectra)
{
    const SkinModel& model = task.skin.model();
    nlohmann::ordered_json json{{"skin", model.id},
                                {"title", model.title},
                                {"citation", model.citation},
                                {"light", task.light.beam == Beam::diffuse ? "diffuse" : "beam"},
                                {"theta_i", task.light.incidence * degrees},
                                {"layers", model.layers},
                                {"wavelengths", task.wavelengths}};
    for (std::size_t k = 0; k < sets.size(); ++k) {
        const SkinSpectrum& spectrum = spectra[k];
        nlohmann::ordered_json set;
        for (std::size_t p = 0; p < model.parameters.size(); ++p)
            set["parameters"][model.parameters[p].name] = sets[k].values()[p];
        set["reflectance"] = spectrum.reflectance;
        set["specular"] = spectrum.specular;
        set["transmittance"] = spectrum.transmittance;
        set["bottom"] = spectrum.bottom;
        set["absorption"] = spectrum.absorption;
        set["error"] = spectrum.error;
        if (has_colour(task.wavelengths)) {
            const auto colour = colour_of(spectrum.wavelengths, spectrum.reflectance);
            const auto list = [](const auto& v) { return nlohmann::ordered_json{v.x, v.y, v.z}; };
            set["XYZ"] = list(colour.xyz);
            set["linear_sRGB"] = list(colour.linear);
            set["sRGB"] = list(colour.srgb);
            set["Lab"] = list(colour.lab);
            set["ITA"] = colour.typology_angle;
        }
        json["sets"].push_back(std::move(set));
    }
    fmt::print("{}\n", json.dump(2));
}

}  // namespace gonio
