// SPDX-License-Identifier: Apache-2.0
// gonio eval MODEL: f at listed directions, from the device and from the reference.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "commands/commands.hpp"
#include "commands/parameters.hpp"
#include "commands/row_list.hpp"
#include "compute/horizon.hpp"
#include "gonio/compute.hpp"

namespace gonio {
namespace {

struct EvalOptions {
    DeviceOptions device;
    std::string model, at = "-";
    bool json = false;
};

std::vector<DirectionPair> read_pairs(const std::string& path)
{
    std::vector<DirectionPair> pairs;
    for (const auto& row : read_rows(path, direction_columns())) pairs.push_back(pair_of(row));
    return pairs;
}

std::vector<std::vector<double>> reference_values(const Material& material,
                                                  const std::vector<DirectionPair>& pairs)
{
    const Reference reference = make_reference(material, Measure::as_printed);
    std::vector<std::vector<double>> values(material.channels());
    for (const DirectionPair& pair : pairs) {
        const auto [l, v] = unit_vectors(pair);
        const bool horizon = pair.theta_i == 90 || pair.theta_o == 90;
        for (std::size_t c = 0; c < values.size(); ++c)
            values[c].push_back(
                horizon && !has_limit_on_horizon(reference, pair, c) ? 0 : reference(l, v, c));
    }
    return values;
}

void print_json(const std::vector<DirectionPair>& pairs,
                const std::vector<std::vector<float>>& device,
                const std::vector<std::vector<double>>& reference)
{
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        nlohmann::ordered_json row{{"theta_i", pairs[k].theta_i},
                                   {"phi_i", pairs[k].phi_i},
                                   {"theta_o", pairs[k].theta_o},
                                   {"phi_o", pairs[k].phi_o}};
        for (std::size_t c = 0; c < device.size(); ++c) {
            row["device"].push_back(device[c][k]);
            row["reference"].push_back(reference[c][k]);
        }
        rows.push_back(row);
    }
    fmt::print("{}\n", nlohmann::ordered_json{{"rows", rows}}.dump(2));
}

void print_csv(const std::vector<std::string>& channels, const std::vector<DirectionPair>& pairs,
               const std::vector<std::vector<float>>& device,
               const std::vector<std::vector<double>>& reference)
{
    fmt::print("theta_i,phi_i,theta_o,phi_o");
    for (const char* source : {"device", "reference"})
        for (const std::string& channel : channels) fmt::print(",{}.{}", source, channel);
    fmt::print("\n");
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        fmt::print("{},{},{},{}", pairs[k].theta_i, pairs[k].phi_i, pairs[k].theta_o,
                   pairs[k].phi_o);
        for (const auto& channel : device) fmt::print(",{}", channel[k]);
        for (const auto& channel : reference) fmt::print(",{}", channel[k]);
        fmt::print("\n");
    }
}

void eval(const EvalOptions& options, const std::vector<std::string>& words)
{
    const Material material{options.model, {lobe_of_words(options.model, words)}};
    const std::vector<DirectionPair> pairs = read_pairs(options.at);
    const auto device = compute_points(options.device.open(), material, Measure::as_printed, pairs);
    const auto reference = reference_values(material, pairs);
    if (options.json)
        print_json(pairs, device, reference);
    else
        print_csv(material.channel_names(), pairs, device, reference);
}

}  // namespace

void add_eval(CLI::App& app)
{
    CLI::App* verb = app.add_subcommand(
        "eval", "Evaluate a model at listed directions, on the device and by its reference");
    const auto options = std::make_shared<EvalOptions>();
    verb->add_option("MODEL", options->model,
                     "a model or an alias; its parameters follow as --name value")
        ->required();
    verb->add_option("--at", options->at,
                     "CSV rows theta_i, phi_i, theta_o, phi_o in degrees; - is standard input");
    verb->add_flag("--json", options->json, "Print JSON");
    options->device.add_to(*verb);
    verb->allow_extras();
    verb->callback([verb, options] { eval(*options, verb->remaining()); });
}

}  // namespace gonio
