// SPDX-License-Identifier: Apache-2.0
// gonio table MODEL: the short form of a scene with one table.
#include <fmt/format.h>

#include "commands/batch_summary.hpp"
#include "commands/commands.hpp"
#include "commands/grid_options.hpp"
#include "commands/parameters.hpp"
#include "gonio/errors.hpp"
#include "gonio/scene.hpp"
#include "plan/timed_grid.hpp"
#include "scene/table.hpp"

namespace gonio {
namespace {

struct TableOptions {
    DeviceOptions device;
    GridOptions grid;
    std::string model, quantity = "brdf", output;
    std::vector<std::string> axes;
    std::optional<double> max_error;
    std::string time;
    bool half = false, dry_run = false, best_effort = false;
    std::string compression = "zip";
};

Budget budget_of(const TableOptions& options)
{
    const auto& most = options.max_error;
    if (most && !(*most >= least_error && *most <= 1))
        throw UsageError(fmt::format("--max-error is {}; allowed is {} to 1", *most, least_error));
    Budget budget;
    budget.max_error = most;
    if (!options.time.empty()) budget.seconds = seconds_of("--time", options.time);
    return budget;
}

std::string format_of(const std::filesystem::path& path)
{
    const std::string extension = path.extension().string();
    for (const char* format : {"exr", "npy", "csv"})
        if (extension == std::string(".") + format) return format;
    if (extension == ".binary") return "merl";
    throw UsageError(fmt::format(
        "{}: the name tells the format; allowed are .exr, .npy, .csv and .binary (MERL)",
        path.string()));
}

void make(const TableOptions& options, const std::vector<std::string>& words)
{
    const std::filesystem::path path =
        options.output.empty() ? options.model + ".exr" : options.output;
    Scene scene;
    scene.directory = path.has_parent_path() ? path.parent_path() : ".";
    scene.materials.push_back(
        {options.model, std::vector{lobe_of_words(options.model, words)}, {}, {}});
    TableRequest request;
    request.name = path.stem().string();
    request.quantity = &find_quantity(options.quantity, Substance::surface);
    request.budget = budget_of(options);
    if (request.quantity->on_grid()) {
        if (!options.axes.empty())
            throw UsageError(fmt::format("the quantity `{}` is over a --grid and has no --axis",
                                         options.quantity));
        if (request.budget.max_error || request.budget.seconds)
            request.fit = options.grid.fit();
        else
            request.grid = options.grid.grid();
    } else {
        if (!options.grid.counts.empty())
            throw UsageError(
                fmt::format("the quantity `{}` has no --grid; write --axis for each of its axes, "
                            "e.g. --axis 'mu = {{ to = 1, count = 64 }}'",
                            options.quantity));
        read_integral_axes(options.axes, scene.materials.front(), request);
    }
    request.solver = request.quantity->solvers.front();
    request.storage = {format_of(path), {options.half, options.compression}};
    if (options.half && request.storage.format != "exr")
        throw UsageError(
            fmt::format("--half is for the format exr, not {}", request.storage.format));
    scene.tables.push_back(request);

    std::vector<Job> jobs = plan_jobs(scene);
    const Device device = options.device.open();
    if (options.dry_run) return print_estimate(device, jobs);
    if (options.best_effort) jobs.front().must_reach = false;
    fit_to_time(device, jobs);
    run_jobs(device, jobs);
}

}  // namespace

void add_table(CLI::App& app)
{
    CLI::App* verb =
        app.add_subcommand("table", "Make one table: a model, its parameters, a grid and a file");
    const auto options = std::make_shared<TableOptions>();
    verb->add_option("MODEL", options->model,
                     "a model or an alias; its parameters follow as --name value")
        ->required();
    options->grid.add_to(*verb);
    verb->add_option("--quantity", options->quantity,
                     "brdf, brdf_cosine: times cos theta_i, or an integral such as dfg");
    verb->add_option("--axis", options->axes,
                     "of an integral, once for each: 'mu = { to = 1, count = 64 }' or a parameter")
        ->allow_extra_args(false);
    verb->add_option("--max-error", options->max_error,
                     "of an integral, or of interpolation on a grid that it chooses, over the "
                     "largest value");
    verb->add_option("--time", options->time,
                     "as exact an integral, or as fine a grid, as \"5 s\" allow");
    verb->add_flag("--best-effort", options->best_effort,
                   "Keep a table that did not reach its max_error");
    verb->add_option("-o,--output", options->output,
                     "file: .exr, .npy, .csv or .binary (default: MODEL.exr)");
    verb->add_flag("--half", options->half, "EXR with 16-bit floats");
    verb->add_option("--compression", options->compression, "of an EXR")
        ->check(CLI::IsMember({"none", "rle", "zips", "zip", "piz"}));
    verb->add_flag("--dry-run", options->dry_run, "Only say size, memory and time");
    options->device.add_to(*verb);
    verb->allow_extras();
    verb->callback([verb, options] { make(*options, verb->remaining()); });
}

}  // namespace gonio
