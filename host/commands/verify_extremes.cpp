// SPDX-License-Identifier: Apache-2.0
// gonio verify --extreme: every hard spot by name, its bound, and what was measured.
#include "commands/verify_extremes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>

#include "gonio/errors.hpp"
#include "plan/interrupt.hpp"
#include "plan/progress.hpp"
#include "verify/extreme.hpp"

namespace gonio {
namespace {

std::string error_text(const Accuracy& accuracy)
{
    return accuracy.not_finite > 0 ? fmt::format("{} not finite", accuracy.not_finite)
                                   : fmt::format("{:.1e}", accuracy.relative);
}

const char* verdict_text(bool passed)
{
    return passed ? "passed" : "FAILED";
}

void print(const std::vector<SpotVerdict>& spots)
{
    fmt::print("{:<42} {:>9} {:>8} {:>10} {:>14}  {}\n", "reflectance models", "error", "bound",
               "condition", "textbook form", "verdict");
    for (const SpotVerdict& spot : spots)
        fmt::print("{:<42} {:>9} {:>8.0e} {:>10.1e} {:>14}  {}\n", spot.name,
                   error_text(spot.device), spot.bound, spot.condition, error_text(spot.textbook),
                   verdict_text(spot.passed()));
    fmt::print(
        "error: largest relative one against double precision; condition: how many times more f "
        "changes than its directions;\ntextbook form: the error of the usual formula in float32\n");
}

void print(const std::vector<MediumVerdict>& media)
{
    fmt::print("\n{:<42} {:>9} {:>10} {:>10} {:>8}  {}\n", "photons in layers", "exact", "measured",
               "deviation", "bound", "verdict");
    for (const MediumVerdict& medium : media)
        fmt::print("{:<42} {:>9.4f} {:>10.4f} {:>8.2f} s {:>6.2f} s  {}\n", medium.name,
                   medium.exact, medium.measured, medium.deviation, medium.bound,
                   verdict_text(medium.passed()));
    fmt::print("s: standard errors\n");
}

void print(const SumVerdict& sum)
{
    fmt::print("\n{:<42} {:>9.1e} {:>19} {:>14.3f}  {}\n",
               fmt::format("sum of {:.0e} photons", sum.photons), sum.error, "", sum.textbook_error,
               verdict_text(sum.passed()));
}

nlohmann::ordered_json json_of(const SpotVerdict& spot)
{
    return {{"name", spot.name},
            {"relative_error", spot.device.relative},
            {"absolute_error_of_maximum", spot.device.absolute},
            {"not_finite", spot.device.not_finite},
            {"bound", spot.bound},
            {"condition", spot.condition},
            {"textbook_relative_error", spot.textbook.relative},
            {"textbook_not_finite", spot.textbook.not_finite},
            {"passed", spot.passed()}};
}

nlohmann::ordered_json json_of(const SumVerdict& sum)
{
    return {{"photons", sum.photons},
            {"relative_error", sum.error},
            {"textbook_relative_error", sum.textbook_error},
            {"passed", sum.passed()}};
}

nlohmann::ordered_json json_of(const MediumVerdict& medium)
{
    return {{"name", medium.name},           {"exact", medium.exact},
            {"measured", medium.measured},   {"standard_error", medium.standard_error},
            {"deviation", medium.deviation}, {"bound", medium.bound},
            {"passed", medium.passed()}};
}

/// Those of some models, or all where none is named.
std::vector<HardSpot> spots_of(const std::vector<std::string>& names)
{
    std::vector<HardSpot> all = hard_spots();
    if (names.empty()) return all;
    std::vector<HardSpot> chosen;
    for (const std::string& name : names) {
        const Model* model = default_lobe(name).model;
        const auto is_of_model = [&](const HardSpot& spot) { return spot.lobe.model == model; };
        if (std::ranges::none_of(all, is_of_model))
            throw UsageError(
                fmt::format("no extreme case has the model `{0}`; `gonio verify {0}` "
                            "has the ends of its parameters",
                            name));
        std::ranges::copy_if(all, std::back_inserter(chosen), is_of_model);
    }
    return chosen;
}

nlohmann::ordered_json array_of(const auto& verdicts)
{
    nlohmann::ordered_json array = nlohmann::ordered_json::array();
    for (const auto& verdict : verdicts) array.push_back(json_of(verdict));
    return array;
}

}  // namespace

void verify_extremes(const Device& device, const std::vector<std::string>& models, bool json)
{
    const std::vector<HardSpot> chosen = spots_of(models);
    std::vector<SpotVerdict> spots;
    std::vector<MediumVerdict> media;
    std::optional<SumVerdict> sum;
    {
        Progress progress((models.empty() ? 2 : 1) * static_cast<double>(chosen.size()));
        for (const HardSpot& spot : chosen) {
            progress.begin(spot.name);
            spots.push_back(verify_spot(device, spot));
            progress.advance(1);
            throw_if_interrupted();
        }
        if (models.empty()) {
            progress.begin("photons in layers");
            media = verify_media(device);
            sum = verify_sum();
        }
    }
    if (json) {
        nlohmann::ordered_json report{{"device", device.info().name},
                                      {"driver", device.info().driver},
                                      {"width", device.width()},
                                      {"spots", array_of(spots)}};
        if (!media.empty()) report["media"] = array_of(media);
        if (sum) report["sum"] = json_of(*sum);
        fmt::print("{}\n", report.dump(2));
    } else {
        print(spots);
        if (!media.empty()) print(media);
        if (sum) print(*sum);
    }
    const auto failed = [](const auto& verdict) { return !verdict.passed(); };
    const auto broken = std::ranges::count_if(spots, failed) +
                        std::ranges::count_if(media, failed) + (sum && failed(*sum) ? 1 : 0);
    if (broken > 0)
        throw CheckFailed(fmt::format("{} of {} extreme cases break their bounds on {} (driver {})",
                                      broken, spots.size() + media.size() + (sum ? 1 : 0),
                                      device.info().name, device.info().driver));
}

}  // namespace gonio
