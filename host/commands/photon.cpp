// SPDX-License-Identifier: Apache-2.0
// gonio photon FILE.mci: runs MCML's input files and writes its .mco files.
#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "commands/commands.hpp"
#include "output/atomic_file.hpp"
#include "output/sidecar.hpp"
#include "photon/bins.hpp"
#include "photon/checkpoint.hpp"
#include "photon/mco.hpp"
#include "plan/interrupt.hpp"
#include "plan/progress.hpp"
#include "version.hpp"

namespace gonio {
namespace {

struct PhotonOptions {
    DeviceOptions device;
    std::string file, directory = ".";
    std::uint64_t seed = 1;
};

/// All that the bytes of a run's files depend on.
nlohmann::ordered_json definition(const MciRun& run, std::uint64_t seed)
{
    return {{"program", GONIO_PROGRAM}, {"seed", seed}, {"input", mco_parameters(run)}};
}

bool is_finished(const std::filesystem::path& mco, const nlohmann::ordered_json& definition)
{
    std::ifstream file(sidecar_path(mco));
    const auto summary = nlohmann::ordered_json::parse(file, nullptr, false);
    return std::filesystem::is_regular_file(mco) && summary.is_object() &&
           summary.value("definition", nlohmann::ordered_json()) == definition;
}

/// Parts of the incident light, each with its standard error.
nlohmann::ordered_json budget_of(const PhotonResult& result)
{
    nlohmann::ordered_json budget;
    const auto add = [&](const std::string& name, const Fraction& part) {
        budget[name] = {{"mean", part.mean}, {"error", part.error}};
    };
    add("specular", result.specular);
    add("diffuse_reflectance", result.diffuse_reflectance);
    add("unscattered_transmittance", result.unscattered_transmittance);
    add("diffuse_transmittance", result.diffuse_transmittance);
    for (std::size_t k = 0; k < result.absorption.size(); ++k)
        add(fmt::format("absorption_{}", k + 1), result.absorption[k]);
    return budget;
}

/// What no bin of the .mco file holds: light beyond the last radius or depth.
nlohmann::ordered_json overflows_of(const PhotonTallies& tallies, const PhotonResult& result)
{
    nlohmann::ordered_json beyond;
    for (const auto& [name, tally] : {std::pair{"reflected", &PhotonTallies::reflected},
                                      std::pair{"transmitted", &PhotonTallies::transmitted},
                                      std::pair{"absorbed", &PhotonTallies::absorbed}}) {
        PhotonTallies one = tallies;
        one.reflected = one.transmitted = one.absorbed = false;
        one.*tally = true;
        beyond[name] = overflow(result, one);
    }
    return beyond;
}

/// Follows a run's photons and writes its two files.
void simulate(const Device& device, const MciRun& run, std::uint64_t seed,
              const std::filesystem::path& path, Progress& progress)
{
    PhotonTracer tracer(device, run.medium, {{}, run.tallies, seed, 0, batch_of(run.photons)});
    Checkpoint checkpoint(path, definition(run, seed).dump());
    std::uint64_t done = 0;
    if (const auto saved = checkpoint.progress(); !saved.is_null()) {
        restore(tracer, saved.at("tracer"));
        done = saved.at("done");
        progress.advance(static_cast<double>(done));
    }
    tracer.trace(run.photons - done, [&](std::uint64_t photons) {
        done += photons;
        progress.advance(static_cast<double>(photons));
        if (interrupted() || checkpoint.is_due())
            checkpoint.save({{"done", done}, {"tracer", state_of(tracer)}});
        throw_if_interrupted();
    });
    const PhotonResult result = tracer.result();
    write_file(path, mco_text(run, result));
    const nlohmann::ordered_json summary{{"definition", definition(run, seed)},
                                         {"budget", budget_of(result)},
                                         {"beyond_the_bins", overflows_of(run.tallies, result)},
                                         {"run",
                                          {{"device", device.info().name},
                                           {"driver", device.info().driver},
                                           {"width", device.width()},
                                           {"kernel_seconds", tracer.kernel_seconds()}}}};
    write_file(sidecar_path(path), summary.dump(2) + "\n");
    checkpoint.remove();
    // The two parts exclude each other: together they vary less than that.
    const double transmittance_error =
        std::hypot(result.unscattered_transmittance.error, result.diffuse_transmittance.error);
    fmt::print("{:<24} {:>11} {:>10.3g} {:>11.6f} {:>8.1e} {:>11.6f} {:>8.1e}\n", run.output,
               run.photons, static_cast<double>(run.photons) / tracer.kernel_seconds(),
               result.diffuse_reflectance.mean, result.diffuse_reflectance.error,
               result.unscattered_transmittance.mean + result.diffuse_transmittance.mean,
               transmittance_error);
}

void photon(const PhotonOptions& options)
{
    const std::vector<MciRun> runs = load_mci(options.file);
    const Device device = options.device.open();
    catch_interrupts();
    prepare_directory(options.directory);
    double photons = 0;
    for (const MciRun& run : runs) photons += static_cast<double>(run.photons);
    Progress progress(photons);
    fmt::print("{:<24} {:>11} {:>10} {:>11} {:>8} {:>11} {:>8}\n", "file", "photons", "photons/s",
               "Rd", "error", "Tt", "error");
    for (const MciRun& run : runs) {
        const std::filesystem::path path = std::filesystem::path(options.directory) / run.output;
        progress.begin(run.output);
        if (is_finished(path, definition(run, options.seed))) {
            progress.advance(static_cast<double>(run.photons));
            fmt::print("{:<24} already finished\n", run.output);
        } else {
            simulate(device, run, options.seed, path, progress);
        }
    }
}

}  // namespace

void add_photon(CLI::App& app)
{
    CLI::App* verb = app.add_subcommand(
        "photon", "Run MCML's input files; write .mco files, and .json with standard errors");
    const auto options = std::make_shared<PhotonOptions>();
    verb->add_option("FILE", options->file, "input file of MCML (.mci)")->required();
    verb->add_option("-o,--output", options->directory, "directory for the files");
    verb->add_option("--seed", options->seed, "of the random numbers");
    options->device.add_to(*verb);
    verb->callback([options] { photon(*options); });
}

}  // namespace gonio
