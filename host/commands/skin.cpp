// SPDX-License-Identifier: Apache-2.0
// gonio skin [MODEL]: reflectance spectra and colours of skin, printed, as tables and as pictures.
#include <fmt/format.h>

#include "commands/commands.hpp"
#include "commands/skin_fit.hpp"
#include "commands/skin_options.hpp"
#include "commands/skin_report.hpp"
#include "gonio/errors.hpp"
#include "output/skin_plot.hpp"

namespace gonio {
namespace {

constexpr std::size_t most_curves = 40;

void draw(const std::string& file, const SkinTask& task, const std::vector<Skin>& sets,
          const std::vector<SkinSpectrum>& spectra)
{
    std::vector<PlottedSpectrum> curves;
    for (std::size_t k = 0; k < sets.size(); ++k) {
        const std::string label = label_of(task, sets[k]);
        curves.push_back({label.empty() ? task.skin.model().id : label, spectra[k].wavelengths,
                          spectra[k].reflectance});
    }
    const SkinModel& model = task.skin.model();
    write_skin_plot(file, fmt::format("{}: {}", model.id, model.title), fixed_text(task), curves);
}

void check_pictures(const std::vector<std::string>& files, std::size_t sets)
{
    for (const std::string& file : files)
        if (is_picture(file) && sets > most_curves)
            throw UsageError(fmt::format("{}: {} sets of parameters; a picture shows up to {}",
                                         file, sets, most_curves));
}

/// words: [MODEL] --name value …; CLI11 would take a value of an option that it does not know for
/// an optional MODEL.
void run_skin(SkinOptions options, std::vector<std::string> words)
{
    if (!words.empty() && !words.front().starts_with("--")) {
        options.model = words.front();
        words.erase(words.begin());
    }
    const SkinTask task = task_of(options, words);
    if (!options.fit.empty()) return run_skin_fit(options, task, words);
    const std::vector<Skin> sets = sets_of(task);
    check_pictures(options.files, sets.size());
    const auto spectra = solve_skin(sets, task.wavelengths, task.light, task.tolerance);
    for (const std::string& file : options.files)
        if (is_picture(file))
            draw(file, task, sets, spectra);
        else
            write_table(file, std::filesystem::path(file).extension().string().substr(1),
                        spectrum_table(task, spectra));
    if (options.json)
        print_spectra_json(task, sets, spectra);
    else if (options.files.empty())
        print_spectra(task, sets, spectra);
}

}  // namespace

void add_skin(CLI::App& app)
{
    CLI::App* verb = app.add_subcommand(
        "skin", "Reflectance spectrum and colour of skin from melanin, blood and more");
    const auto options = std::make_shared<SkinOptions>();
    verb->add_option("--wavelengths", options->wavelengths,
                     "FROM:TO:STEP or a list, nm; 380:780:5 if not given, 400:700:10 for a fit");
    verb->add_option("--light", options->light, "beam or diffuse")
        ->check(CLI::IsMember({"beam", "diffuse"}));
    verb->add_option("--theta_i", options->theta_i, "of the beam to the normal, degrees");
    verb->add_option("--error", options->error, "largest error of a reflectance")
        ->capture_default_str();
    verb->add_option("-o,--output", options->files,
                     "a file for the table (.csv, .npy, .exr) or the picture (.png, .svg); again "
                     "for more")
        ->allow_extra_args(false);
    CLI::Option* fit = verb->add_option(
        "--fit", options->fit,
        "find the parameters of a measured spectrum: CSV with wavelengths in nm and reflectances");
    verb->add_option("--column", options->column, "of the file to fit; the second if not given")
        ->needs(fit);
    verb->add_option("--free", options->free,
                     "a,b,c: the parameters to fit; if not given, those that the model does not "
                     "hold and that are not set")
        ->needs(fit);
    verb->add_flag("--json", options->json, "Print JSON");
    verb->footer(
        "gonio skin [MODEL] [--PARAMETER VALUE]... [OPTIONS]\n"
        "MODEL is one of `gonio models --skin`, meglinski_2002 if there is none, or a .toml of "
        "your\n"
        "own. VALUE is a number, or several: a,b,c or from:to:count or from:to:count:log.\n"
        "Light travels by the radiative transfer equation, solved without noise "
        "(adding-doubling).\n"
        "Reflectance includes what the surface reflects, as a spectrophotometer with a closed\n"
        "gloss trap measures it; `specular` is that part alone. Colours: D65, CIE 1931, 2 "
        "degrees.");
    verb->allow_extras();
    verb->callback([verb, options] { run_skin(*options, verb->remaining()); });
}

}  // namespace gonio
