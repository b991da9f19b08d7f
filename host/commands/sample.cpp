// SPDX-License-Identifier: Apache-2.0
// gonio sample MODEL: random viewers as a renderer draws them, and the albedo that they estimate.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "commands/commands.hpp"
#include "commands/parameters.hpp"
#include "gonio/errors.hpp"
#include "gonio/sampling.hpp"
#include "grid/angles.hpp"

namespace gonio {
namespace {

constexpr std::uint64_t samples_at_a_time = std::uint64_t{1} << 18;

struct SampleOptions {
    DeviceOptions device;
    std::string model;
    double theta_i = 45, phi_i = 0;
    std::uint64_t count = 1000, seed = 1;
    bool json = false;
};

/// Of the weights of one channel.
struct WeightSums {
    double sum = 0, squares = 0;

    double mean(double count) const { return sum / count; }

    /// Standard error of the mean; infinite for one sample.
    double error(double count) const
    {
        if (count < 2) return std::numeric_limits<double>::infinity();
        const double spread = std::max(squares / count - mean(count) * mean(count), 0.0);
        return std::sqrt(spread / (count - 1));
    }
};

struct Summary {
    std::vector<WeightSums> channels;
    std::uint64_t count = 0, below_horizon = 0;

    void add(const ViewerSamples& samples)
    {
        count += samples.viewer.size();
        for (const glm::vec3& viewer : samples.viewer) below_horizon += viewer.z <= 0 ? 1 : 0;
        for (std::size_t c = 0; c < channels.size(); ++c)
            for (const float single : samples.weight[c]) {
                const auto weight = static_cast<double>(single);
                channels[c].sum += weight;
                channels[c].squares += weight * weight;
            }
    }

    std::vector<double> albedo() const
    {
        std::vector<double> all;
        for (const WeightSums& channel : channels)
            all.push_back(channel.mean(static_cast<double>(count)));
        return all;
    }

    std::vector<double> error() const
    {
        std::vector<double> all;
        for (const WeightSums& channel : channels)
            all.push_back(channel.error(static_cast<double>(count)));
        return all;
    }
};

/// Angle from the normal, and azimuth in [0, 360), in degrees.
struct Angles {
    float theta, phi;

    explicit Angles(const glm::dvec3& v)
    {
        constexpr double degrees = 180 / std::numbers::pi;
        theta = static_cast<float>(std::atan2(std::hypot(v.x, v.y), v.z) * degrees);
        phi = static_cast<float>(std::atan2(v.y, v.x) * degrees);
        if (phi < 0) phi = static_cast<float>(static_cast<double>(phi) + 360);
        if (phi >= 360) phi = 0;
    }
};

void print_csv(const ViewerSamples& samples)
{
    for (std::size_t k = 0; k < samples.pdf.size(); ++k) {
        const Angles at(samples.viewer[k]);
        fmt::print("{},{},{}", at.theta, at.phi, samples.pdf[k]);
        for (const auto& channel : samples.weight) fmt::print(",{}", channel[k]);
        fmt::print("\n");
    }
}

/// Rows of an array, one a line, so that no number of samples is too large.
void print_json(const ViewerSamples& samples, bool first)
{
    for (std::size_t k = 0; k < samples.pdf.size(); ++k) {
        const Angles at(samples.viewer[k]);
        nlohmann::ordered_json row{
            {"theta_o", at.theta}, {"phi_o", at.phi}, {"pdf", samples.pdf[k]}};
        for (const auto& channel : samples.weight) row["weight"].push_back(channel[k]);
        fmt::print("{}\n    {}", first && k == 0 ? "" : ",", row.dump());
    }
}

void print_head(const std::vector<std::string>& channels, bool json)
{
    if (json) return fmt::print("{{\n  \"rows\": [");
    fmt::print("theta_o,phi_o,pdf");
    for (const std::string& channel : channels) fmt::print(",weight.{}", channel);
    fmt::print("\n");
}

void print_summary(const Summary& summary, const std::vector<std::string>& channels, bool json)
{
    const std::vector<double> albedo = summary.albedo(), error = summary.error();
    if (json) {
        fmt::print(
            "\n  ],\n  \"below_horizon\": {},\n  \"directional_albedo\": {},\n"
            "  \"standard_error\": {}\n}}\n",
            summary.below_horizon, nlohmann::json(albedo).dump(), nlohmann::json(error).dump());
        return;
    }
    for (std::size_t c = 0; c < channels.size(); ++c)
        fmt::print(stderr, "directional albedo {}: {:.6g} +- {:.2g}\n", channels[c], albedo[c],
                   error[c]);
    fmt::print(stderr, "below the horizon: {} of {} samples\n", summary.below_horizon,
               summary.count);
}

void sample(const SampleOptions& options, const std::vector<std::string>& words)
{
    const Material material{options.model, {lobe_of_words(options.model, words)}};
    if (!(options.theta_i >= 0 && options.theta_i < 90))
        throw UsageError(
            fmt::format("`theta_i` is {}; allowed is 0 to below 90 deg", options.theta_i));
    if (!std::isfinite(options.phi_i)) throw UsageError("`phi_i` is not a finite angle");
    if (options.count == 0) throw UsageError("`n` is 0; allowed is 1 and more");
    const Device device = options.device.open();
    const Incidence light{cosine_of_degrees(options.theta_i), options.phi_i};
    const std::vector<std::string> channels = material.channel_names();
    Summary summary{std::vector<WeightSums>(channels.size())};
    while (summary.count < options.count) {
        const std::uint64_t first = summary.count;
        const ViewerSamples samples = sample_viewers(
            device, material, light,
            {options.seed, first, std::min(samples_at_a_time, options.count - first)});
        if (first == 0) print_head(channels, options.json);
        if (options.json)
            print_json(samples, first == 0);
        else
            print_csv(samples);
        summary.add(samples);
    }
    print_summary(summary, channels, options.json);
}

}  // namespace

void add_sample(CLI::App& app)
{
    CLI::App* verb =
        app.add_subcommand("sample", "Draw random viewers for a light, with their pdf and weight");
    const auto options = std::make_shared<SampleOptions>();
    verb->add_option("MODEL", options->model,
                     "a model or an alias; its parameters follow as --name value")
        ->required();
    verb->add_option("--theta_i", options->theta_i,
                     "angle from the normal to the light in degrees, below 90 (default: 45)");
    verb->add_option("--phi_i", options->phi_i, "azimuth of the light in degrees (default: 0)");
    verb->add_option("-n", options->count, "how many samples (default: 1000)");
    verb->add_option("--seed", options->seed,
                     "of the random numbers: sample k of a seed is always the same (default: 1)");
    verb->add_flag("--json", options->json, "Print JSON");
    options->device.add_to(*verb);
    verb->footer(
        "Rows are theta_o, phi_o (degrees), the pdf per solid angle of viewers (1/sr) and the\n"
        "weight f cos(theta_o)/pdf of each channel. The mean weight estimates the directional\n"
        "albedo: it follows on standard error, or behind the rows of JSON, with its standard\n"
        "error. A sample below the horizon (theta_o >= 90) counts, with a pdf and weight of 0.");
    verb->allow_extras();
    verb->callback([verb, options] { sample(*options, verb->remaining()); });
}

}  // namespace gonio
