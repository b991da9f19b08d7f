// SPDX-License-Identifier: Apache-2.0
// gonio models --measure: accuracy, speed and the largest albedo of models on a device.
#include "commands/measured_models.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "plan/interrupt.hpp"
#include "plan/progress.hpp"
#include "verify/measure.hpp"

namespace gonio {
namespace {

nlohmann::ordered_json json_of(const Measured& measured)
{
    return {{"id", measured.verdict.model},
            {"largest_relative_error", measured.verdict.accuracy.relative},
            {"bound", measured.verdict.bound},
            {"values_per_second", measured.values_per_second},
            {"store_fraction", measured.store_fraction},
            {"largest_albedo",
             {{"value", measured.gain.albedo},
              {"error", measured.gain.error},
              {"where", measured.gain.where}}}};
}

}  // namespace

void print_measured(const Device& device, const std::vector<const Model*>& models, bool json)
{
    catch_interrupts();
    std::vector<Measured> all;
    {
        Progress progress(static_cast<double>(models.size()));
        for (const Model* model : models) {
            progress.begin(std::string(model->id));
            all.push_back(measure_model(device, *model));
            progress.advance(1);
            throw_if_interrupted();
        }
    }
    const DeviceInfo& info = device.info();
    if (json) {
        nlohmann::ordered_json array = nlohmann::ordered_json::array();
        for (const Measured& measured : all) array.push_back(json_of(measured));
        fmt::print("{}\n", nlohmann::ordered_json{{"device", info.name},
                                                  {"driver", info.driver},
                                                  {"width", device.width()},
                                                  {"models", array}}
                               .dump(2));
        return;
    }
    fmt::print("on {} ({}, driver {}, width {})\n", info.name, info.platform_name, info.driver,
               device.width());
    fmt::print("{:<21} {:>9} {:>8} {:>9} {:>11}  {}\n", "model", "error", "Geval/s", "of store",
               "albedo up to", "where");
    for (const Measured& measured : all)
        fmt::print("{:<21} {:>9.1e} {:>8.2f} {:>9.2f} {:>12.5g}  {}\n", measured.verdict.model,
                   measured.verdict.accuracy.relative, measured.values_per_second * 1e-9,
                   measured.store_fraction, measured.gain.albedo, measured.gain.where);
}

}  // namespace gonio
