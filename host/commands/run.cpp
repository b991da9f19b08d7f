// SPDX-License-Identifier: Apache-2.0
// gonio run SCENE.toml: every table that a scene asks for.
#include <fmt/format.h>

#include "commands/batch_summary.hpp"
#include "commands/commands.hpp"
#include "gonio/scene.hpp"
#include "output/contact_sheet.hpp"
#include "plan/timed_grid.hpp"

namespace gonio {
namespace {

struct RunOptions {
    DeviceOptions device;
    std::string scene, output, sheet;
    bool dry_run = false, best_effort = false, no_plan = false;
};

void run(const RunOptions& options)
{
    const Scene scene = load_scene(options.scene);
    for (const std::string& warning : scene.warnings) fmt::print(stderr, "{}\n", warning);
    std::vector<Job> jobs = plan_jobs(scene, options.output);
    const Device device = options.device.open();
    if (options.dry_run) return print_estimate(device, jobs);
    if (options.best_effort)
        for (Job& job : jobs) job.must_reach = false;
    fit_to_time(device, jobs, {.leave_out = !options.no_plan});
    run_jobs(device, jobs, !options.no_plan);
    if (options.sheet.empty()) return;
    std::vector<ContactCard> cards;
    for (const SceneMaterial& material : scene.materials)
        if (const auto* lobes = std::get_if<std::vector<Lobe>>(&material.made_of))
            cards.push_back(make_card({material.name, *lobes, material.ambient}));
    write_contact_sheet(options.sheet, device, cards);
    fmt::print("{}\n", options.sheet);
}

}  // namespace

void add_run(CLI::App& app)
{
    CLI::App* verb = app.add_subcommand(
        "run", "Make all tables of a scene; finished ones are kept, an interrupted run goes on");
    const auto options = std::make_shared<RunOptions>();
    verb->add_option("SCENE", options->scene, "scene file (TOML)")->required();
    verb->add_option("-o,--output", options->output,
                     "directory for the tables, in place of the scene's");
    verb->add_option("--sheet", options->sheet,
                     "PNG with a sphere and a lobe for every material of the scene");
    verb->add_flag("--dry-run", options->dry_run, "Only say size, memory and time");
    verb->add_flag("--best-effort", options->best_effort,
                   "Keep tables that did not reach their max_error");
    verb->add_flag(
        "--no-plan", options->no_plan,
        "Make all tables the general way: nothing that `gonio plan` names is left out of "
        "BRDFs, no layers are, and finished tables are made again");
    options->device.add_to(*verb);
    verb->callback([options] { run(*options); });
}

}  // namespace gonio
