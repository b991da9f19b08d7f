// SPDX-License-Identifier: Apache-2.0
// gonio table MODEL: the short form of a scene with one table.
#include <fmt/format.h>

#include <charconv>

#include "commands/batch_summary.hpp"
#include "commands/commands.hpp"
#include "commands/parameters.hpp"
#include "gonio/errors.hpp"
#include "gonio/scene.hpp"
#include "scene/table.hpp"

namespace gonio {
namespace {

constexpr auto default_grid = "90x90x360";

struct TableOptions {
    DeviceOptions device;
    std::string model, grid, kind, samples = "centre", spacing = "linear", quantity = "brdf",
                                   output;
    std::vector<std::string> axes;
    bool half = false, dry_run = false;
    std::string compression = "zip";
};

/// "90x90x360" -> 90, 90, 360
std::vector<std::size_t> counts_of(const std::string& text)
{
    std::vector<std::size_t> counts;
    for (const std::string& part : CLI::detail::split(text, 'x')) {
        std::size_t count = 0;
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), count);
        if (error != std::errc() || end != part.data() + part.size())
            throw UsageError(fmt::format(
                "--grid is \"{}\"; allowed are whole numbers with x between, e.g. 90x90x360",
                text));
        counts.push_back(count);
    }
    return counts;
}

Grid grid_of(const TableOptions& options)
{
    const std::vector<std::size_t> n =
        counts_of(options.grid.empty() ? default_grid : options.grid);
    const std::string kind =
        options.kind.empty() ? (n.size() == 4 ? "anisotropic" : "isotropic") : options.kind;
    if (n.size() != (kind == "anisotropic" ? 4U : 3U))
        throw UsageError(
            fmt::format("--grid {} has {} axes; {} grids have {}", options.grid, n.size(), kind,
                        kind == "anisotropic" ? "4: theta_i, phi_i, theta_o, phi_o" : "3"));
    const Samples samples = options.samples == "node" ? Samples::node : Samples::centre;
    if (kind == "anisotropic") return anisotropic_grid(n[0], n[1], n[2], n[3], samples);
    if (kind == "rusinkiewicz")
        return rusinkiewicz_grid(n[0], n[1], n[2], samples,
                                 options.spacing == "merl" ? Spacing::merl : Spacing::linear);
    return isotropic_grid(n[0], n[1], n[2], samples);
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
    if (request.quantity->on_grid()) {
        if (!options.axes.empty())
            throw UsageError(fmt::format("the quantity `{}` is over a --grid and has no --axis",
                                         options.quantity));
        request.grid = grid_of(options);
    } else {
        if (!options.grid.empty())
            throw UsageError(
                fmt::format("the quantity `{}` has no --grid; write --axis for each of its axes, "
                            "e.g. --axis 'mu = {{ to = 1, count = 64 }}'",
                            options.quantity));
        read_integral_axes(options.axes, scene.materials.front(), request);
    }
    request.solver = request.quantity->solvers.front();
    request.storage = {format_of(path), {options.half, options.compression}};
    scene.tables.push_back(request);

    const std::vector<Job> jobs = plan_jobs(scene);
    const Device device = options.device.open();
    if (options.dry_run) return print_estimate(device, jobs);
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
    verb->add_option("--grid", options->grid,
                     fmt::format("samples per axis, e.g. 32x64x32x64 (default: {})", default_grid));
    verb->add_option("--kind", options->kind, "kind of the grid (default: by the number of axes)")
        ->check(CLI::IsMember({"isotropic", "anisotropic", "rusinkiewicz"}));
    verb->add_option("--samples", options->samples, "samples in cells' centres or on nodes")
        ->check(CLI::IsMember({"centre", "node"}));
    verb->add_option("--spacing", options->spacing, "of theta_h on a Rusinkiewicz grid")
        ->check(CLI::IsMember({"linear", "merl"}));
    verb->add_option("--quantity", options->quantity,
                     "brdf, brdf_cosine: times cos theta_i, or an integral such as dfg");
    verb->add_option("--axis", options->axes,
                     "of an integral, once for each: 'mu = { to = 1, count = 64 }' or a parameter")
        ->allow_extra_args(false);
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
