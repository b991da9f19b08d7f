// SPDX-License-Identifier: Apache-2.0
// gonio plan SCENE.toml: what would be computed, what is left out, and why.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "commands/commands.hpp"
#include "gonio/scene.hpp"
#include "output/check.hpp"
#include "picture/explain_picture.hpp"
#include "plan/batch.hpp"
#include "plan/estimate.hpp"
#include "plan/explain.hpp"
#include "plan/forecast.hpp"
#include "plan/timed_grid.hpp"

namespace gonio {
namespace {

struct PlanOptions {
    DeviceOptions device;
    std::string scene, output;
    bool json = false;
};

nlohmann::ordered_json json_of(const std::vector<LeftOut>& left_out)
{
    nlohmann::ordered_json array = nlohmann::ordered_json::array();
    for (const auto& [what, why, saving] : left_out) {
        array.push_back({{"what", what}, {"why", why}});
        if (saving) array.back()["saving"] = *saving;
    }
    return array;
}

nlohmann::ordered_json json_of(const Job& job, const JobPlan& plan, const Forecast& forecast)
{
    const TableSize size = size_of(job);
    nlohmann::ordered_json json{{"file", job.path.string()},
                                {"quantity", job.header.quantity},
                                {"solver", plan.solver},
                                {"kernel", plan.kernel},
                                {"definitions", plan.definitions},
                                {"width", plan.width},
                                {"cells", job.header.cells()},
                                {"file_bytes", size.file_bytes},
                                {"memory_bytes", size.memory_bytes},
                                {"finished", plan.finished},
                                {"left_out", json_of(plan.left_out)}};
    if (job.seconds) json["time"] = *job.seconds;
    if (job.fit)
        json.erase("cells");
    else if (job.header.find("interpolation.error"))
        json["interpolation_error"] = job.interpolation_error;
    if (plan.tiling)
        json["tiles"] = {{"count", plan.tiling->tiles * job.materials.size()},
                         {"bytes", plan.tiling->bytes}};
    if (plan.tally_bytes > 0) json["tally_bytes"] = plan.tally_bytes;
    if (const auto asked = asked_error(job)) json["max_error"] = *asked;
    if (!std::isnan(forecast.seconds)) json["seconds"] = forecast.seconds;
    if (forecast.photons > 0) json["photons"] = forecast.photons;
    if (!std::isnan(forecast.error)) {
        json["error"] = forecast.error;
        json["error_of"] = forecast.error_of;
        json["error_is_bound"] = forecast.is_bound;
    }
    return json;
}

void print(const std::vector<LeftOut>& left_out)
{
    for (const auto& [what, why, saving] : left_out)
        fmt::print("    left out: {}: {}{}\n", what, why,
                   saving ? fmt::format(" ({:.3g} times the work)", *saving) : "");
}

/// "about 0.3 s and 2e+04 photons, an error of about 0.01 of the largest value"
std::string text_of(const Job& job, const Forecast& forecast)
{
    if (std::isnan(forecast.seconds)) return "too few photons come this far to tell the time";
    std::string text = time_text(forecast.seconds);
    if (!text.starts_with("below")) text = "about " + text;
    if (forecast.photons > 0)
        text += fmt::format(" and {:.1e} photons{}", forecast.photons,
                            job.profile ? " a wavelength" : "");
    if (std::isnan(forecast.error)) return text;
    text += fmt::format(", an error of {} {:.1e} of {}", forecast.is_bound ? "at most" : "about",
                        forecast.error, forecast.error_of);
    const auto asked = asked_error(job);
    if (!forecast.is_bound && asked && forecast.error > *asked)
        text += fmt::format(", where {:.1e} is allowed", *asked);
    return text;
}

void print(const Job& job, const JobPlan& plan, const Forecast& forecast)
{
    const bool number = job.header.axes.empty();
    fmt::print("{}: {}{}, solver {}\n", job.path.string(), job.header.quantity,
               number    ? ""
               : job.fit ? fmt::format(" of as many cells as {} s are enough for", *job.seconds)
                         : fmt::format(" of {} cells", shape_text(job.header)),
               plan.solver);
    if (!plan.kernel.empty())
        fmt::print("    {} at width {}{}{}\n", plan.kernel, plan.width,
                   plan.definitions.empty() ? "" : " with ", fmt::join(plan.definitions, " "));
    if (plan.tiling)
        fmt::print("    tiles: {} of {}\n", plan.tiling->tiles * job.materials.size(),
                   size_text(static_cast<double>(plan.tiling->bytes)));
    if (plan.tally_bytes > 0)
        fmt::print("    tallies: {}\n", size_text(static_cast<double>(plan.tally_bytes)));
    if (const std::string text = interpolation_text(job); !text.empty())
        fmt::print("    grid: {}\n", text);
    if (!plan.finished) fmt::print("    {}\n", text_of(job, forecast));
    print(plan.left_out);
}

nlohmann::ordered_json json_of(const PicturePlan& plan, unsigned width, double seconds)
{
    nlohmann::ordered_json stages = nlohmann::ordered_json::array();
    for (const PictureStage& stage : plan.stages)
        stages.push_back({{"what", stage.what},
                          {"kernel", stage.kernel},
                          {"definitions", stage.definitions},
                          {"share", stage.share}});
    return {{"width", width},
            {"seconds", seconds},
            {"stages", stages},
            {"left_out", json_of(plan.left_out)}};
}

void print(const PictureRequest& picture, const PicturePlan& plan, unsigned width, double seconds)
{
    fmt::print("picture: {} x {} pixels, width {}, about {}\n", picture.width, picture.height,
               width, time_text(seconds));
    for (const PictureStage& stage : plan.stages) {
        fmt::print("    {}", stage.what);
        if (!stage.kernel.empty()) fmt::print(", {}", stage.kernel);
        if (!stage.definitions.empty()) fmt::print(" with {}", fmt::join(stage.definitions, " "));
        fmt::print("{}\n", stage.share > 0
                               ? fmt::format(" ({:.0f} % of the work)", 100 * stage.share)
                               : "");
    }
    print(plan.left_out);
}

void plan_scene(const PlanOptions& options)
{
    const Scene scene = load_scene(options.scene);
    std::vector<Job> jobs = plan_jobs(scene, options.output);
    keep_earlier_grids(jobs);
    const Device device = options.device.open();
    const std::vector<const Job*> twins = equal_jobs(jobs);
    const std::vector<Forecast> costs = forecasts(device, jobs);
    std::vector<JobPlan> plans;
    for (std::size_t k = 0; k < jobs.size(); ++k) {
        plans.push_back(explain(device, jobs[k]));
        if (const Job* twin = twins[k]; twin != nullptr && !plans[k].finished)
            plans[k].left_out.push_back(
                {"all of it", fmt::format("it equals {}", twin->path.string()), {}});
    }
    std::optional<PicturePlan> picture;
    double picture_takes = 0;
    if (scene.picture) {
        picture = explain(device, *scene.picture, scene.materials);
        picture_takes = picture_seconds(device, *scene.picture, scene.materials);
    }
    if (!options.json) {
        for (std::size_t k = 0; k < jobs.size(); ++k) print(jobs[k], plans[k], costs[k]);
        if (picture) print(*scene.picture, *picture, device.width(), picture_takes);
        if (!jobs.empty()) fmt::print("\n{}", estimate_text(jobs, costs));
        return;
    }
    nlohmann::ordered_json json{{"tables", nlohmann::ordered_json::array()}};
    for (std::size_t k = 0; k < jobs.size(); ++k)
        json["tables"].push_back(json_of(jobs[k], plans[k], costs[k]));
    if (picture) json["picture"] = json_of(*picture, device.width(), picture_takes);
    fmt::print("{}\n", json.dump(2));
}

}  // namespace

void add_plan(CLI::App& app)
{
    CLI::App* verb = app.add_subcommand(
        "plan",
        "Say what `run` and `picture` would compute for a scene, what they leave out, and why");
    const auto options = std::make_shared<PlanOptions>();
    verb->add_option("SCENE", options->scene, "scene file (TOML)")->required();
    verb->add_option("-o,--output", options->output,
                     "directory for the tables, in place of the scene's");
    verb->add_flag("--json", options->json, "Print JSON");
    options->device.add_to(*verb);
    verb->callback([options] { plan_scene(*options); });
}

}  // namespace gonio
