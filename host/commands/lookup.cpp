// SPDX-License-Identifier: Apache-2.0
// gonio lookup FILE: a table's values between its samples, at listed directions or coordinates.
#include "output/lookup.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "commands/commands.hpp"
#include "commands/parameters.hpp"
#include "commands/row_list.hpp"
#include "gonio/errors.hpp"
#include "gonio/model.hpp"
#include "output/grid_coordinates.hpp"

namespace gonio {
namespace {

constexpr std::array interpolations{"nearest", "linear", "cubic"};  // as the enumeration

struct LookupOptions {
    std::string file, at = "-", interpolation = "linear";
    bool json = false;
};

/// The columns of a table that is not over directions: its own axes, to the ends of their cells.
std::vector<Column> columns_of(const TableHeader& header)
{
    std::vector<Column> columns;
    for (std::size_t a = header.sweep_axes; a < header.axes.size(); ++a) {
        const auto& [name, unit, values, samples] = header.axes[a];
        double first = values.front(), last = values.back();
        if (samples == Samples::centre && values.size() > 1) {
            first -= (values[1] - first) / 2;
            last += (last - values[values.size() - 2]) / 2;
        }
        columns.push_back({name, unit, std::min(first, last), std::max(first, last)});
    }
    return columns;
}

/// The values of the swept axes, each given once by its name.
std::vector<double> sweep_values(const TableHeader& header, const std::vector<std::string>& words)
{
    const std::size_t count = header.sweep_axes;
    std::vector<std::string_view> names;
    for (std::size_t a = 0; a < count; ++a) names.push_back(header.axes[a].name);
    std::vector<std::optional<double>> given(count);
    for (const auto& [name, value] : named_values(words)) {
        const auto found = std::ranges::find(names, name);
        if (found == names.end())
            throw UsageError(fmt::format("the table has no swept axis `{}`{}", name,
                                         names.empty() ? "" : suggestion(name, names)));
        given[static_cast<std::size_t>(found - names.begin())] = number_of(value, name);
    }
    std::vector<double> values;
    for (std::size_t a = 0; a < count; ++a) {
        if (!given[a])
            throw UsageError(fmt::format(
                "the table is swept over `{0}`: choose one value with --{0}; it has {1:.7g}",
                names[a], fmt::join(header.axes[a].values, ", ")));
        values.push_back(*given[a]);
    }
    return values;
}

using Rows = std::vector<std::vector<double>>;

void print_json(const LookupOptions& options, const TableHeader& header,
                const std::vector<Column>& columns, const Rows& places, const Rows& values)
{
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (std::size_t k = 0; k < places.size(); ++k) {
        nlohmann::ordered_json& row = rows.emplace_back();
        for (std::size_t c = 0; c < columns.size(); ++c) row[columns[c].name] = places[k][c];
        row["value"] = values[k];
    }
    const nlohmann::ordered_json all{{"table", options.file},
                                     {"quantity", header.quantity},
                                     {"unit", header.unit},
                                     {"channels", header.channels},
                                     {"interpolation", options.interpolation},
                                     {"rows", rows}};
    fmt::print("{}\n", all.dump(2));
}

void print_csv(const TableHeader& header, const std::vector<Column>& columns, const Rows& places,
               const Rows& values)
{
    std::vector<std::string> names;
    for (const Column& column : columns) names.push_back(column.name);
    fmt::print("{},{}\n", fmt::join(names, ","), fmt::join(header.channels, ","));
    for (std::size_t k = 0; k < places.size(); ++k)
        fmt::print("{},{}\n", fmt::join(places[k], ","), fmt::join(values[k], ","));
}

void look_up(const LookupOptions& options, const std::vector<std::string>& words)
{
    const Table table = read_table(options.file);
    const auto how = std::ranges::find(interpolations, options.interpolation);
    const Lookup lookup(table, static_cast<Interpolation>(how - interpolations.begin()));
    const std::vector<double> swept = sweep_values(table.header, words);
    const auto kind = grid_kind_of(table.header);
    const std::vector<Column> columns = kind ? direction_columns() : columns_of(table.header);
    const Rows places = read_rows(options.at, columns);
    Rows values;
    for (const auto& row : places) {
        std::vector<double> place = swept;
        const auto inner = kind ? grid_coordinates(*kind, pair_of(row)) : row;
        place.insert(place.end(), inner.begin(), inner.end());
        values.push_back(lookup.at(place));
    }
    if (options.json)
        print_json(options, table.header, columns, places, values);
    else
        print_csv(table.header, columns, places, values);
}

}  // namespace

void add_lookup(CLI::App& app)
{
    CLI::App* verb = app.add_subcommand(
        "lookup", "Read values back from a table, interpolated at listed directions");
    const auto options = std::make_shared<LookupOptions>();
    verb->add_option("FILE", options->file,
                     "any table that gonio wrote, or a MERL .binary; a value of each swept axis "
                     "follows as --name value")
        ->required();
    verb->add_option("--at", options->at,
                     "CSV rows theta_i, phi_i, theta_o, phi_o in degrees, or one column for each "
                     "axis of a table that is not over directions; - is standard input");
    verb->add_option("--interpolation", options->interpolation, "nearest, linear or cubic")
        ->check(
            CLI::IsMember(std::vector<std::string>(interpolations.begin(), interpolations.end())));
    verb->add_flag("--json", options->json, "Print JSON");
    verb->allow_extras();
    verb->callback([verb, options] { look_up(*options, verb->remaining()); });
}

}  // namespace gonio
