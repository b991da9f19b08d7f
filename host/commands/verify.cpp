// SPDX-License-Identifier: Apache-2.0
// gonio verify: is this device right? What to run on a new card or driver before trusting it.
#include "verify/verify.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "commands/commands.hpp"
#include "commands/verify_extremes.hpp"
#include "gonio/errors.hpp"
#include "gonio/material.hpp"
#include "plan/interrupt.hpp"
#include "plan/progress.hpp"

namespace gonio {
namespace {

struct VerifyOptions {
    DeviceOptions device;
    std::vector<std::string> models;
    bool quick = false, extreme = false, json = false;
};

nlohmann::ordered_json json_of(const Verdict& verdict)
{
    return {{"model", verdict.model},
            {"largest_relative_error", verdict.accuracy.relative},
            {"bound", verdict.bound},
            {"largest_absolute_error_of_maximum", verdict.accuracy.absolute},
            {"not_finite", verdict.accuracy.not_finite},
            {"negative", verdict.negative},
            {"reciprocity_defect", verdict.reciprocity_defect},
            {"values", verdict.accuracy.checked},
            {"worst", verdict.worst},
            {"passed", verdict.passed()}};
}

void print(const std::vector<Verdict>& verdicts)
{
    fmt::print("{:<20} {:>10} {:>9} {:>10} {:>12}  {}\n", "model", "relative", "bound",
               "not finite", "reciprocity", "verdict");
    for (const Verdict& verdict : verdicts) {
        fmt::print("{:<20} {:>10.2e} {:>9.0e} {:>10} {:>12.1e}  {}\n", verdict.model,
                   verdict.accuracy.relative, verdict.bound, verdict.accuracy.not_finite,
                   verdict.reciprocity_defect, verdict.passed() ? "passed" : "FAILED");
        if (!verdict.passed())
            fmt::print(
                "    expected {:.9g}, got {:.9g} with {}; negative: {}; absolute: {:.1e} of the "
                "maximum\n",
                verdict.accuracy.reference, verdict.accuracy.device, verdict.worst,
                verdict.negative, verdict.accuracy.absolute);
    }
}

void verify(const VerifyOptions& options)
{
    const Device device = options.device.open();
    if (options.extreme) return verify_extremes(device, options.models, options.json);
    std::vector<const Model*> chosen;
    for (const std::string& name : options.models) chosen.push_back(default_lobe(name).model);
    if (chosen.empty())
        for (const Model& model : models()) chosen.push_back(&model);

    std::vector<Verdict> verdicts;
    {
        Progress progress(static_cast<double>(chosen.size()));
        for (const Model* model : chosen) {
            progress.begin(std::string(model->id));
            verdicts.push_back(verify_model(device, *model, options.quick));
            progress.advance(1);
            throw_if_interrupted();
        }
    }
    const auto failed =
        std::ranges::count_if(verdicts, [](const Verdict& verdict) { return !verdict.passed(); });
    if (options.json) {
        nlohmann::ordered_json array = nlohmann::ordered_json::array();
        for (const Verdict& verdict : verdicts) array.push_back(json_of(verdict));
        fmt::print("{}\n", nlohmann::ordered_json{{"device", device.info().name},
                                                  {"driver", device.info().driver},
                                                  {"width", device.width()},
                                                  {"models", array}}
                               .dump(2));
    } else {
        print(verdicts);
    }
    if (failed > 0)
        throw CheckFailed(
            fmt::format("{} of {} models break their bounds on {} ({}, driver {}, width {})",
                        failed, verdicts.size(), device.info().name, device.info().platform_name,
                        device.info().driver, device.width()));
}

}  // namespace

void add_verify(CLI::App& app)
{
    CLI::App* verb = app.add_subcommand(
        "verify", "Compare every model on the device with its reference, extremes included");
    const auto options = std::make_shared<VerifyOptions>();
    verb->add_option("MODEL", options->models, "only these models");
    CLI::Option* quick = verb->add_flag("--quick", options->quick, "A small part of the cases");
    verb->add_flag("--extreme", options->extreme,
                   "Stiff and extreme cases by name, with what textbook formulas make of them")
        ->excludes(quick);
    verb->add_flag("--json", options->json, "Print JSON");
    options->device.add_to(*verb);
    verb->callback([options] { verify(*options); });
}

}  // namespace gonio
