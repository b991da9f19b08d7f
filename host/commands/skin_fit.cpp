// SPDX-License-Identifier: Apache-2.0
// Runs a fit and reports it as text, JSON, table and picture.
#include "commands/skin_fit.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "output/skin_plot.hpp"
#include "skin/fit.hpp"
#include "skin/measured.hpp"

namespace gonio {
namespace {

void print(const SkinOptions& options, const SkinFit& fit)
{
    const SkinModel& model = fit.skin.model();
    fmt::print("{}: {}\n", model.id, model.title);
    fmt::print("fitted to {}{} at {} wavelengths from {} to {} nm\n\n", options.fit,
               options.column.empty() ? "" : fmt::format(", column {},", options.column),
               fit.measured.size(), fit.spectrum.wavelengths.front(),
               fit.spectrum.wavelengths.back());
    for (const auto& [index, value, error, at_limit] : fit.parameters) {
        const SkinParameter& parameter = model.parameters[index];
        fmt::print("{:<20} {:>10.5g} +- {:.2g}{}{}\n", parameter.name, value, error,
                   parameter.unit == "1" ? "" : " " + parameter.unit,
                   at_limit ? "   at the limit of its range" : "");
    }
    fmt::print("\nmean residual        {:>10.4f}\nrms residual         {:>10.4f}\n",
               fit.mean_residual, fit.rms_residual);
    fmt::print("largest residual     {:>10.4f}\n", fit.largest_residual);
}

void print_json(const SkinFit& fit)
{
    const SkinModel& model = fit.skin.model();
    nlohmann::ordered_json json{{"skin", model.id}};
    for (std::size_t k = 0; k < model.parameters.size(); ++k)
        json["parameters"][model.parameters[k].name]["value"] = fit.skin.values()[k];
    for (const auto& [index, value, error, at_limit] : fit.parameters) {
        auto& parameter = json["parameters"][model.parameters[index].name];
        parameter["standard_error"] = error;
        parameter["at_limit"] = at_limit;
    }
    json["mean_residual"] = fit.mean_residual;
    json["rms_residual"] = fit.rms_residual;
    json["largest_residual"] = fit.largest_residual;
    json["wavelengths"] = fit.spectrum.wavelengths;
    json["measured"] = fit.measured;
    json["reflectance"] = fit.spectrum.reflectance;
    fmt::print("{}\n", json.dump(2));
}

/// The table of the fitted spectrum with the measured one beside it.
Table table_of(const SkinTask& task, const SkinFit& fit)
{
    SkinTask fitted = task;
    fitted.skin = fit.skin;
    Table table = spectrum_table(fitted, {fit.spectrum});
    table.header.channels.emplace_back("measured");
    table.values.push_back(fit.measured);
    table.header.attributes.emplace_back("mean_residual", fit.mean_residual);
    return table;
}

/// The fitted spectrum goes on where it was not fitted, so that it has a colour.
void draw(const std::string& file, const SkinOptions& options, const SkinFit& fit,
          const skin::Spectrum& measured, const SkinTask& task)
{
    const auto wavelengths = default_wavelengths();
    const bool known = fit.skin.least_wavelength() <= wavelengths.front() &&
                       fit.skin.greatest_wavelength() >= wavelengths.back();
    const SkinSpectrum shown =
        known ? solve_skin({fit.skin}, wavelengths, task.light, task.tolerance)[0] : fit.spectrum;
    const std::string source = std::filesystem::path(options.fit).filename();
    std::string found = fmt::format("mean residual {:.4f}", fit.mean_residual);
    for (const FittedParameter& parameter : fit.parameters)
        found += fmt::format(", {} {:.3g}", fit.skin.model().parameters[parameter.index].name,
                             parameter.value);
    write_skin_plot(
        file, fmt::format("{} fitted to {} {}", fit.skin.model().id, source, options.column), found,
        {{"fitted", shown.wavelengths, shown.reflectance},
         {"measured", measured.wavelengths(), measured.values(), true}});
}

}  // namespace

void run_skin_fit(const SkinOptions& options, const SkinTask& task,
                  const std::vector<std::string>& words)
{
    const skin::Spectrum measured = skin::read_measured(options.fit, options.column);
    const auto varied = free_parameters(options, task.skin.model(), words);
    const SkinFit fit = fit_skin(task.skin, varied, measured, task.wavelengths, task.light);
    for (const std::string& file : options.files) {
        if (!is_picture(file)) {
            write_table(file, std::filesystem::path(file).extension().string().substr(1),
                        table_of(task, fit));
            continue;
        }
        draw(file, options, fit, measured, task);
    }
    options.json ? print_json(fit) : print(options, fit);
}

}  // namespace gonio
