// SPDX-License-Identifier: Apache-2.0
// gonio bench: error against run time on a device, as a report.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "commands/commands.hpp"
#include "gonio/errors.hpp"
#include "gonio/model.hpp"
#include "opencl/store_rate.hpp"
#include "plan/interrupt.hpp"
#include "plan/progress.hpp"
#include "timings/aligned.hpp"
#include "timings/sections.hpp"
#include "version.hpp"

namespace gonio {
namespace {

constexpr double noisy = 0.2;  // spread of the store rate that is worth a warning

struct BenchOptions {
    DeviceOptions device;
    std::string directory = "bench-report";
    std::vector<std::string> sections, compared;
    bool quick = false;
};

std::vector<BenchSection> chosen_sections(const std::vector<std::string>& names)
{
    if (names.empty()) return bench_sections();
    std::vector<std::string_view> all;
    for (const BenchSection& section : bench_sections()) all.push_back(section.name);
    std::vector<BenchSection> chosen;
    for (const std::string& name : names) {
        const auto found = std::ranges::find(bench_sections(), name, &BenchSection::name);
        if (found == bench_sections().end())
            throw UsageError(
                fmt::format("there is no section `{}`{}", name, suggestion(name, all)));
        chosen.push_back(*found);
    }
    return chosen;
}

nlohmann::ordered_json about(const Device& device, const BenchOptions& options)
{
    const DeviceInfo& info = device.info();
    return {{"program", GONIO_PROGRAM},
            {"device", info.name},
            {"platform", info.platform_name},
            {"driver", info.driver},
            {"compute_units", info.compute_units},
            {"clock_mhz", info.clock_mhz},
            {"width", device.width()},
            {"kernels", "OpenCL C 1.2, strict IEEE arithmetic, no fast-math"},
            {"cxx", GONIO_CXX},
            {"quick", options.quick}};
}

/// The best points of each plot, or all where none is marked.
void print(const BenchReport& report)
{
    for (const BenchPlot& plot : report.plots) {
        fmt::print("{}\n", plot.title);
        const auto best = std::ranges::count(plot.points, true, &BenchPoint::best);
        std::vector<std::vector<std::string>> rows;
        for (const BenchPoint& point : plot.points)
            if (best == 0 || point.best)
                rows.push_back({"  ", point.series, point.label,
                                fmt::format("{}: {:.4g}", plot.x_title, point.x.median),
                                fmt::format("{}: {:.4g}", plot.y_title, point.y.median)});
        fmt::print("{}", aligned(rows));
    }
}

/// Runs sections until all are done, or Ctrl-C; what was done by then is in the report.
bool run_sections(const Device& device, const BenchOptions& options,
                  const std::vector<BenchSection>& sections, BenchReport& report)
{
    Progress progress(static_cast<double>(sections.size()));
    const BenchRun run{device, options.quick, [&](const std::string& what) {
                           progress.begin(what);
                           throw_if_interrupted();
                       }};
    StoreRate store(device.state());
    std::vector<double> stored;
    const auto watch = [&] {
        for (int k = 0; k < 3; ++k) stored.push_back(store.seconds());
        const Quartiles all = quartiles_of(stored);
        report.about["noise"] = (all.high - all.low) / all.median;
    };
    try {
        watch();
        for (const BenchSection& section : sections) {
            report.plots.push_back(section.run(run));
            progress.advance(1);
            watch();
        }
        return true;
    } catch (const Interrupted&) {
        return false;
    }
}

void bench(const BenchOptions& options)
{
    if (!options.compared.empty()) {
        const BenchReport first = read_report(options.compared[0]);
        return fmt::print("{}", comparison(first, read_report(options.compared[1])));
    }
    const std::vector<BenchSection> sections = chosen_sections(options.sections);
    const Device device = options.device.open();
    catch_interrupts();
    BenchReport report{about(device, options), {}};
    const bool whole = run_sections(device, options, sections, report);
    if (!report.plots.empty()) {
        write_report(options.directory, report);
        print(report);
        const double noise = report.about["noise"];
        if (noise > noisy)
            fmt::print(stderr,
                       "gonio: the machine was noisy: the rate at which it writes memory "
                       "varied by {:.0f} %\n",
                       100 * noise);
        fmt::print("{}/report.html\n", options.directory);
    }
    if (!whole) throw Interrupted();
}

}  // namespace

void add_bench(CLI::App& app)
{
    CLI::App* verb = app.add_subcommand(
        "bench", "Measure error against run time on the device, as a page with plots");
    const auto options = std::make_shared<BenchOptions>();
    std::vector<std::string> names;
    for (const BenchSection& section : bench_sections())
        names.push_back(fmt::format("{} ({})", section.name, section.what));
    verb->add_option("SECTION", options->sections,
                     fmt::format("only these: {}", fmt::join(names, "; ")));
    CLI::Option* directory =
        verb->add_option("-o,--output", options->directory,
                         "folder for report.html, results.json, results.csv and the plots")
            ->capture_default_str();
    CLI::Option* quick =
        verb->add_flag("--quick", options->quick, "Less of everything: under a minute");
    verb->add_option("--compare", options->compared,
                     "two reports (folders or results.json): ratios of the second to the first")
        ->expected(2)
        ->excludes(directory)
        ->excludes(quick);
    options->device.add_to(*verb);
    verb->callback([options] { bench(*options); });
}

}  // namespace gonio
