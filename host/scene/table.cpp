// SPDX-License-Identifier: Apache-2.0
// Reads tables: which material, which quantity, over what, how exact, into which file.
#include "scene/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "gonio/model.hpp"
#include "scene/material.hpp"

namespace gonio {
namespace {

/// "5 s", "2 min" or "1 h", or seconds as a number.
double read_seconds(const Value& value)
{
    if (value.is_number()) return value.number(0);
    return located(value.where(),
                   [&] { return seconds_of(fmt::format("`{}`", value.name()), value.text()); });
}

Budget read_budget(const Section& table)
{
    Budget budget;
    if (const auto error = table.find("max_error"))
        budget.max_error = error->number(least_error, 1);
    if (const auto time = table.find("time")) budget.seconds = read_seconds(*time);
    if (const auto photons = table.find("photons"))
        budget.photons = photons->count(1, std::uint64_t{1} << 62);
    return budget;
}

/// Refuses what the solver of this quantity cannot use.
void check_solver(const Section& table, const TableRequest& request)
{
    if (const auto error = table.find("ring_error");
        error && request.quantity->of != Substance::skin)
        error->fail("`ring_error` is for `reflectance_r` of skin over wavelengths");
    if (request.quantity->of != Substance::surface) return;
    for (const auto key : {"light", "theta_i", "radius", "seed"})
        if (const auto value = table.find(key))
            value->fail(fmt::format("`{}` is for tables of layers, not of a surface", key));
    const auto needed = request.quantity->on_grid() ? "grid" : "axes";
    const auto other = request.quantity->on_grid() ? "axes" : "grid";
    if (const auto value = table.find(other))
        value->fail(fmt::format("the quantity `{}` has no `{}`, it needs a `{}`",
                                request.quantity->id, other, needed));
    if (request.quantity->on_grid() || !request.quantity->axes.empty()) table.at(needed);
    if (request.solver == "quadrature")
        if (const auto photons = table.find("photons"))
            photons->fail(
                "an integral has no `photons`: `max_error` or `time` set how exact it is");
    if (request.solver != "closed_form") return;
    if (const auto photons = table.find("photons"))
        photons->fail(
            fmt::format("the quantity `{}` has no `photons`: its closed form is exact everywhere",
                        request.quantity->id));
    if (request.fit && !table.find("max_error") && !table.find("time"))
        table.at("grid").fail(
            "this grid needs a count for each of its angles, or the table a `max_error` that "
            "interpolation keeps to, or a `time`");
    if (request.fit) return;
    for (const auto key : {"max_error", "time"})
        if (const auto value = table.find(key))
            value->fail(fmt::format(
                "a grid with counts has no `{}`: leave the counts away, and they are chosen by it",
                key));
}

std::string read_solver(const Section& table, const Quantity& quantity)
{
    auto words = quantity.solvers;
    words.insert(words.begin(), "auto");
    const auto solver = table.find("solver");
    const auto choice = solver ? solver->choice(words) : 0;
    return std::string(choice == 0 ? quantity.solvers.front() : words[choice]);
}

bool fits_merl(const Grid& grid)
{
    const auto merl = rusinkiewicz_grid(90, 90, 180, Samples::centre, Spacing::merl);
    return grid.kind == merl.kind &&
           std::ranges::equal(grid.axes, merl.axes,
                              [](const Axis& a, const Axis& b) { return a.values == b.values; });
}

TableRequest read_request(const Section& table, std::size_t which,
                          const std::vector<SceneMaterial>& materials, const Storage& storage)
{
    TableRequest request;
    request.where = table.where();
    request.material = which;
    const SceneMaterial& material = materials[which];
    if (const auto grid = table.find("grid")) {
        request.fit = read_grid_fit(*grid);
        if (!request.fit) request.grid = read_grid(*grid);
    }
    if (const auto axes = table.find("axes")) request.axes = read_axes(*axes);
    request.budget = read_budget(table);
    request.storage = storage;
    read_storage(table, request.storage);

    const Value quantity = table.at("quantity");
    const auto id = quantity.text();
    const auto* skin = std::get_if<Skin>(&material.made_of);
    const bool surface = std::holds_alternative<std::vector<Lobe>>(material.made_of);
    const Substance of = skin ? Substance::skin : surface ? Substance::surface : Substance::layers;
    request.quantity = located(quantity.where(), [&] { return &find_quantity(id, of); });
    request.solver = read_solver(table, *request.quantity);
    check_solver(table, request);
    if (request.fit && !surface)
        table.at("grid").fail("a grid of layers needs a count for each of its angles");
    if (of == Substance::layers) read_light_request(table, request);
    if (skin) read_skin_request(table, *skin, request);
    if (const auto axes = table.find("axes"); axes && surface)
        read_integral_axes(*axes, material, request);
    if (request.storage.format == "merl" && !(request.grid && fits_merl(*request.grid)))
        table.at("grid").fail(
            "the format merl holds a rusinkiewicz grid of 90 x 90 x 180 with spacing = \"merl\" "
            "and samples = \"centre\" only");
    const auto name = table.find("name");
    request.name = name ? read_name(*name) : fmt::format("{}-{}", material.name, id);
    return request;
}

}  // namespace

double seconds_of(std::string_view name, std::string_view text)
{
    static constexpr std::array<std::pair<std::string_view, double>, 3> units = {
        {{"s", 1}, {"min", 60}, {"h", 3600}}};
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    std::string_view unit(end, text.data() + text.size());
    unit.remove_prefix(std::min(unit.find_first_not_of(' '), unit.size()));
    const auto known =
        std::ranges::find(units, unit, [](const auto& entry) { return entry.first; });
    if (error != std::errc() || known == units.end() || !(number >= 0 && number < 1e9))
        throw UsageError(
            fmt::format("{} cannot be \"{}\"; allowed is a time such as \"5 s\", \"2 min\" or "
                        "\"1 h\"",
                        name, text));
    return number * known->second;
}

void read_storage(const Section& section, Storage& storage)
{
    static const std::vector<std::string_view> formats = {"exr", "npy", "csv", "merl"};
    static const std::vector<std::string_view> compressions = {"none", "rle", "zips", "zip", "piz"};
    if (const auto format = section.find("format"))
        storage.format = formats[format->choice(formats)];
    if (const auto precision = section.find("precision"))
        storage.write.half = precision->choice({"float", "half"}) == 1;
    if (const auto compression = section.find("compression"))
        storage.write.compression = compressions[compression->choice(compressions)];
    for (const auto key : {"precision", "compression"})
        if (const auto value = section.find(key); value && storage.format != "exr")
            value->fail(fmt::format("`{}` is for the format exr, not {}", key, storage.format));
}

std::vector<TableRequest> read_table_requests(const Value& value,
                                              const std::vector<SceneMaterial>& materials,
                                              const Storage& storage)
{
    const Section table(value);
    table.allow({"material", "name", "quantity", "grid", "axes", "light", "theta_i", "radius",
                 "seed", "solver", "max_error", "ring_error", "time", "photons", "format",
                 "precision", "compression"});
    if (const auto material = table.find("material"))
        return {read_request(table, find_material(*material, materials), materials, storage)};
    std::vector<TableRequest> requests;
    for (std::size_t material = 0; material < materials.size(); ++material)
        requests.push_back(read_request(table, material, materials, storage));
    return requests;
}

}  // namespace gonio
