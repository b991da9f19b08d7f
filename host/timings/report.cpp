// SPDX-License-Identifier: Apache-2.0
// Reports as JSON, CSV, pictures and a page.
#include "timings/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "gonio/errors.hpp"
#include "opencl/embedded.hpp"
#include "output/atomic_file.hpp"

namespace gonio {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Quartiles& spread)
{
    return {{"median", spread.median}, {"low", spread.low}, {"high", spread.high}};
}

Quartiles quartiles_from(const Json& json)
{
    return {json.at("median"), json.at("low"), json.at("high")};
}

Json json_of(const BenchPlot& plot)
{
    Json points = Json::array();
    for (const BenchPoint& point : plot.points)
        points.push_back({{"series", point.series},
                          {"label", point.label},
                          {"x", json_of(point.x)},
                          {"y", json_of(point.y)},
                          {"best", point.best},
                          {"more", point.more}});
    return {
        {"id", plot.id},
        {"title", plot.title},
        {"note", plot.note},
        {"x",
         {{"title", plot.x_title}, {"logarithmic", plot.x_logarithmic}, {"names", plot.x_names}}},
        {"y", {{"title", plot.y_title}, {"logarithmic", plot.y_logarithmic}}},
        {"joined", plot.joined},
        {"points", points}};
}

BenchPlot plot_from(const Json& json)
{
    BenchPlot plot{json.at("id"),
                   json.at("title"),
                   json.at("note"),
                   json.at("x").at("title"),
                   json.at("y").at("title"),
                   json.at("x").at("logarithmic"),
                   json.at("y").at("logarithmic"),
                   json.at("joined"),
                   json.at("x").value("names", std::vector<std::string>())};
    for (const Json& point : json.at("points"))
        plot.points.push_back({point.at("series"), point.at("label"), quartiles_from(point.at("x")),
                               quartiles_from(point.at("y")), point.at("best"), point.at("more")});
    return plot;
}

std::string quoted(const std::string& text)
{
    return text.find(',') == std::string::npos ? text : fmt::format("\"{}\"", text);
}

/// The further numbers of any point.
std::set<std::string> names_of_more(const BenchReport& report)
{
    std::set<std::string> names;
    for (const BenchPlot& plot : report.plots)
        for (const BenchPoint& point : plot.points)
            for (const auto& [name, value] : point.more) names.insert(name);
    return names;
}

std::string csv_of(const BenchReport& report)
{
    const std::set<std::string> names = names_of_more(report);
    std::string text = "plot,series,label,x_title,x,x_low,x_high,y_title,y,y_low,y_high,best";
    for (const std::string& name : names) text += ',' + name;
    text += '\n';
    for (const BenchPlot& plot : report.plots)
        for (const BenchPoint& point : plot.points) {
            text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{:d}", plot.id,
                                quoted(point.series), quoted(point.label), quoted(plot.x_title),
                                point.x.median, point.x.low, point.x.high, quoted(plot.y_title),
                                point.y.median, point.y.low, point.y.high, point.best);
            for (const std::string& name : names)
                text += point.more.contains(name) ? fmt::format(",{}", point.more.at(name)) : ",";
            text += '\n';
        }
    return text;
}

std::string_view embedded_page(std::string_view path)
{
    return std::ranges::find(page_files(), path, &EmbeddedFile::path)->text;
}

/// The page with the library of charts and the results in it, so that it needs no other file.
std::string page_of(const Json& results)
{
    std::string text = results.dump();
    // A "<" in a script could end it.
    for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos; at += 6)
        text.replace(at, 1, "\\u003c");
    std::string page(embedded_page("timings/report.html"));
    const auto fill = [&](std::string_view mark, std::string_view with) {
        page.replace(page.find(mark), mark.size(), with);
    };
    fill("/* CHARTS */", embedded_page("chart.min.js"));
    fill("/* RESULTS */", text);
    return page;
}

}  // namespace

Quartiles quartiles_of(std::vector<double> measurements)
{
    std::ranges::sort(measurements);
    const auto at = [&](std::size_t quarters) {
        return measurements[(measurements.size() - 1) * quarters / 4];
    };
    return {measurements[measurements.size() / 2], at(1), at(3)};
}

void mark_best(BenchPlot& plot)
{
    for (BenchPoint& point : plot.points)
        point.best =
            point.y.median > 0 && std::ranges::none_of(plot.points, [&](const BenchPoint& other) {
                return other.y.median > 0 && other.x.median <= point.x.median &&
                       other.y.median <= point.y.median &&
                       (other.x.median < point.x.median || other.y.median < point.y.median);
            });
}

Json json_of(const BenchReport& report)
{
    Json plots = Json::array();
    for (const BenchPlot& plot : report.plots) plots.push_back(json_of(plot));
    return {{"format", "gonio bench 1"}, {"about", report.about}, {"plots", plots}};
}

BenchReport read_report(const std::filesystem::path& path)
{
    const std::filesystem::path file = is_directory(path) ? path / "results.json" : path;
    std::ifstream stream(file);
    if (!stream) throw UsageError(fmt::format("{}: there is no such file", file.string()));
    try {
        const Json json = Json::parse(stream);
        BenchReport report{json.at("about"), {}};
        for (const Json& plot : json.at("plots")) report.plots.push_back(plot_from(plot));
        return report;
    } catch (const Json::exception& error) {
        throw UsageError(
            fmt::format("{}: not the results of `gonio bench`: {}", file.string(), error.what()));
    }
}

void write_report(const std::filesystem::path& directory, const BenchReport& report)
{
    prepare_directory(directory);
    const Json results = json_of(report);
    for (const BenchPlot& plot : report.plots)
        for (const char* extension : {".svg", ".png"})
            write_bench_plot(directory / (plot.id + extension), plot);
    write_file(directory / "results.json", results.dump(2) + '\n');
    write_file(directory / "results.csv", csv_of(report));
    write_file(directory / "report.html", page_of(results));
}

}  // namespace gonio
