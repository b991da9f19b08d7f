// SPDX-License-Identifier: Apache-2.0
// gonio plan SCENE.toml: what would be computed, what is left out, and why.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "commands/commands.hpp"
#include "gonio/scene.hpp"
#include "opencl/store_rate.hpp"
#include "output/check.hpp"
#include "plan/batch.hpp"
#include "plan/estimate.hpp"
#include "plan/explain.hpp"

namespace gonio {
namespace {

struct PlanOptions {
    DeviceOptions device;
    std::string scene, output;
    bool json = false;
};

nlohmann::ordered_json json_of(const Job& job, const JobPlan& plan, const Estimate& cost)
{
    nlohmann::ordered_json left_out = nlohmann::ordered_json::array();
    for (const auto& [what, why, saving] : plan.left_out) {
        left_out.push_back({{"what", what}, {"why", why}});
        if (saving) left_out.back()["saving"] = *saving;
    }
    nlohmann::ordered_json json{{"file", job.path.string()},
                                {"quantity", job.header.quantity},
                                {"solver", plan.solver},
                                {"kernel", plan.kernel},
                                {"definitions", plan.definitions},
                                {"width", plan.width},
                                {"cells", job.header.cells()},
                                {"file_bytes", cost.file_bytes},
                                {"memory_bytes", cost.memory_bytes},
                                {"finished", plan.finished},
                                {"left_out", left_out}};
    if (job.header.find("interpolation.error"))
        json["interpolation_error"] = job.interpolation_error;
    if (!std::isnan(cost.seconds)) json["seconds"] = cost.seconds;
    return json;
}

void print(const Job& job, const JobPlan& plan)
{
    const bool number = job.header.axes.empty();
    fmt::print("{}: {}{}, solver {}\n", job.path.string(), job.header.quantity,
               number ? "" : fmt::format(" of {} cells", shape_text(job.header)), plan.solver);
    if (!plan.kernel.empty())
        fmt::print("    {} at width {}{}{}\n", plan.kernel, plan.width,
                   plan.definitions.empty() ? "" : " with ", fmt::join(plan.definitions, " "));
    if (job.header.find("interpolation.error"))
        fmt::print(
            "    grid: interpolation is off by {:.2g} of the largest value, {:.2g} is asked\n",
            job.interpolation_error, job.max_error);
    for (const auto& [what, why, saving] : plan.left_out)
        fmt::print("    left out: {}: {}{}\n", what, why,
                   saving ? fmt::format(" ({:.3g} times the work)", *saving) : "");
}

void plan_scene(const PlanOptions& options)
{
    const std::vector<Job> jobs = plan_jobs(load_scene(options.scene), options.output);
    const Device device = options.device.open();
    const double rate = 0.5 * stored_values_per_second(device);
    const std::vector<const Job*> twins = equal_jobs(jobs);
    std::vector<JobPlan> plans;
    for (std::size_t k = 0; k < jobs.size(); ++k) {
        plans.push_back(explain(device, jobs[k]));
        if (const Job* twin = twins[k]; twin != nullptr && !plans[k].finished)
            plans[k].left_out.push_back(
                {"all of it", fmt::format("it equals {}", twin->path.string()), {}});
    }
    if (!options.json) {
        for (std::size_t k = 0; k < jobs.size(); ++k) print(jobs[k], plans[k]);
        fmt::print("\n{}", estimate_text(jobs, rate));
        return;
    }
    nlohmann::ordered_json array = nlohmann::ordered_json::array();
    for (std::size_t k = 0; k < jobs.size(); ++k)
        array.push_back(json_of(jobs[k], plans[k], estimate(jobs[k], rate)));
    fmt::print("{}\n", nlohmann::ordered_json{{"tables", array}}.dump(2));
}

}  // namespace

void add_plan(CLI::App& app)
{
    CLI::App* verb = app.add_subcommand(
        "plan", "Say what `run` would compute for a scene, what it leaves out, and why");
    const auto options = std::make_shared<PlanOptions>();
    verb->add_option("SCENE", options->scene, "scene file (TOML)")->required();
    verb->add_option("-o,--output", options->output,
                     "directory for the tables, in place of the scene's");
    verb->add_flag("--json", options->json, "Print JSON");
    options->device.add_to(*verb);
    verb->callback([options] { plan_scene(*options); });
}

}  // namespace gonio
