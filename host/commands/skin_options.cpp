// SPDX-License-Identifier: Apache-2.0
// Models, parameters, ladders, wavelengths and light from words.
#include "commands/skin_options.hpp"

#include <fmt/format.h>

#include <CLI/StringTools.hpp>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "commands/parameters.hpp"
#include "gonio/errors.hpp"

namespace gonio {
namespace {

constexpr std::size_t most_sets = 1000, most_wavelengths = 10000, most_steps = 1000;

std::vector<double> numbers_of(const std::string& text, char separator, std::string_view what)
{
    std::vector<double> numbers;
    for (const std::string& part : CLI::detail::split(text, separator))
        numbers.push_back(number_of(part, what));
    return numbers;
}

/// from:to:count, both ends included, or from:to:count:log.
std::vector<double> range_of(std::string text, const std::string& name)
{
    const bool logarithmic = text.ends_with(":log");
    if (logarithmic) text.resize(text.size() - 4);
    const std::vector<double> numbers = numbers_of(text, ':', name);
    if (numbers.size() != 3)
        throw UsageError(fmt::format("`{}` is \"{}\"; a range is from:to:count", name, text));
    const double from = numbers[0], to = numbers[1], count = numbers[2];
    if (!(count >= 2 && count <= most_steps) || count != std::floor(count))
        throw UsageError(
            fmt::format("`{}` has a count of {}; allowed is a whole number from 2 "
                        "to {}",
                        name, count, most_steps));
    if (logarithmic && !(from > 0 && to > 0))
        throw UsageError(
            fmt::format("`{}` is from {} to {}; log needs both above 0", name, from, to));
    std::vector<double> values;
    for (double k = 0; k < count; ++k) {
        const double position = k / (count - 1);
        values.push_back(logarithmic ? from * std::pow(to / from, position)
                                     : std::lerp(from, to, position));
    }
    values.back() = to;
    return values;
}

void set(SkinTask& task, const std::string& name, const std::string& text)
{
    const bool range = text.find(':') != std::string::npos;
    auto values = range ? range_of(text, name) : numbers_of(text, ',', name);
    for (const double value : values) task.skin.set(name, value);
    task.skin.set(name, values.front());
    if (values.size() == 1) return;
    const auto ordered = [&](auto breaks) {
        return std::ranges::adjacent_find(values, breaks) == values.end();
    };
    if (!ordered(std::greater_equal<>()) && !ordered(std::less_equal<>()))
        throw UsageError(fmt::format("the values of `{}` must all ascend or all descend", name));
    task.ladders.push_back({name, std::move(values)});
}

/// 400 to 700 nm in steps of 10: it keeps both bands of haemoglobin apart.
std::vector<double> fit_wavelengths()
{
    std::vector<double> all;
    for (int wavelength = 400; wavelength <= 700; wavelength += 10) all.push_back(wavelength);
    return all;
}

std::vector<double> wavelengths_of(const std::string& text, bool fit)
{
    constexpr std::string_view what = "wavelengths";
    if (text.empty()) return fit ? fit_wavelengths() : default_wavelengths();
    std::vector<double> all;
    if (text.find(':') == std::string::npos) {
        all = numbers_of(text, ',', what);
        if (std::ranges::adjacent_find(all, std::greater_equal<>()) != all.end())
            throw UsageError("`wavelengths` must ascend");
        return all;
    }
    const std::vector<double> numbers = numbers_of(text, ':', what);
    if (numbers.size() != 3 || !(numbers[0] <= numbers[1]) || !(numbers[2] > 0))
        throw UsageError(
            fmt::format("`wavelengths` is \"{}\"; allowed is FROM:TO:STEP or a list, nm", text));
    const double count = std::floor((numbers[1] - numbers[0]) / numbers[2] + 1e-9) + 1;
    if (!(count <= most_wavelengths))
        throw UsageError(
            fmt::format("`wavelengths` are {}; allowed are {}", count, most_wavelengths));
    for (double k = 0; k < count; ++k) all.push_back(numbers[0] + k * numbers[2]);
    return all;
}

LightSource light_of(const SkinOptions& options)
{
    if (!(options.theta_i >= 0 && options.theta_i < 90))
        throw UsageError(
            fmt::format("`theta_i` is {}; allowed is 0 to below 90 deg", options.theta_i));
    const bool diffuse = options.light == "diffuse";
    if (diffuse && options.theta_i != 0)
        throw UsageError("`theta_i` is for a beam, not for diffuse light");
    return {diffuse ? Beam::diffuse : Beam::pencil, options.theta_i * std::numbers::pi / 180};
}

void check_files(const std::vector<std::string>& files)
{
    for (const std::string& file : files) {
        const std::string ending = std::filesystem::path(file).extension();
        if (!is_picture(file) && ending != ".csv" && ending != ".npy" && ending != ".exr")
            throw UsageError(
                fmt::format("{}: the name tells the format; allowed are .png, .svg, "
                            ".csv, .npy and .exr",
                            file));
    }
}

}  // namespace

bool is_picture(const std::string& file)
{
    return file.ends_with(".png") || file.ends_with(".svg");
}

SkinTask task_of(const SkinOptions& options, const std::vector<std::string>& words)
{
    SkinTask task{.skin = Skin(find_skin_model(options.model)),
                  .wavelengths = wavelengths_of(options.wavelengths, !options.fit.empty()),
                  .light = light_of(options),
                  .tolerance = options.error};
    if (!(options.error >= 1e-8 && options.error <= 0.1))
        throw UsageError(fmt::format("`error` is {}; allowed is 1e-8 to 0.1", options.error));
    check_files(options.files);
    std::vector<std::string> seen;
    double sets = 1;
    for (const auto& [name, text] : named_values(words)) {
        set(task, name, text);
        if (std::ranges::find(seen, name) != seen.end())
            throw UsageError(fmt::format("--{} is there twice", name));
        seen.push_back(name);
    }
    for (const SkinLadder& ladder : task.ladders) sets *= static_cast<double>(ladder.values.size());
    if (sets > most_sets)
        throw UsageError(fmt::format("{} sets of parameters; allowed are {}", sets, most_sets));
    if (!options.fit.empty() && !task.ladders.empty())
        throw UsageError(fmt::format("`{}` has several values; a fit starts from one",
                                     task.ladders.front().parameter));
    return task;
}

std::vector<std::size_t> free_parameters(const SkinOptions& options, const SkinModel& model,
                                         const std::vector<std::string>& words)
{
    std::vector<std::size_t> varied;
    if (!options.free.empty()) {
        for (const std::string& name : CLI::detail::split(options.free, ','))
            varied.push_back(model.index_of(name));
        return varied;
    }
    std::vector<std::string> kept = model.held;
    for (const auto& [name, value] : named_values(words)) kept.push_back(name);
    for (std::size_t k = 0; k < model.parameters.size(); ++k)
        if (std::ranges::find(kept, model.parameters[k].name) == kept.end()) varied.push_back(k);
    return varied;
}

}  // namespace gonio
