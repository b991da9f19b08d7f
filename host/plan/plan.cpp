// SPDX-License-Identifier: Apache-2.0
// From a scene to jobs: sweeps become materials of one job, or jobs.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "gonio/errors.hpp"
#include "gonio/job.hpp"
#include "output/check.hpp"
#include "photon/albedo_inversion.hpp"
#include "plan/fitted_grid.hpp"
#include "plan/grid_header.hpp"
#include "plan/header.hpp"
#include "plan/integral_axes.hpp"
#include "plan/lobe_names.hpp"
#include "plan/skin_job.hpp"
#include "plan/swept_layers.hpp"
#include "quadrature/derived.hpp"
#include "scene/located.hpp"

namespace gonio {
namespace {

constexpr std::size_t max_points = 65536;  // values of all sweeps combined, over all tables
constexpr std::size_t max_files = 10000;
constexpr std::uint64_t default_photons = 1'000'000;  // where a table has no budget

/// Every combination of the sweeps' values, the last sweep fastest; a single empty one if there are
/// no sweeps.
std::vector<std::vector<double>> combinations(const std::vector<Sweep>& sweeps)
{
    std::vector<std::vector<double>> points{{}};
    for (const Sweep& sweep : sweeps) {
        std::vector<std::vector<double>> longer;
        for (const auto& point : points)
            for (const double value : sweep.values) {
                longer.push_back(point);
                longer.back().push_back(value);
            }
        points = std::move(longer);
    }
    return points;
}

std::vector<Lobe> at_point(std::vector<Lobe> lobes, const std::vector<Sweep>& sweeps,
                           const std::vector<double>& point)
{
    for (std::size_t k = 0; k < sweeps.size(); ++k)
        lobes[sweeps[k].part].set(sweeps[k].parameter, std::vector{point[k]});
    return lobes;
}

std::string extension(const std::string& format)
{
    return format == "merl" ? ".binary" : "." + format;
}

std::size_t product(const std::vector<Sweep>& sweeps)
{
    std::size_t points = 1;
    for (const Sweep& sweep : sweeps)
        if (__builtin_mul_overflow(points, sweep.values.size(), &points)) return SIZE_MAX;
    return points;
}

class Planner {
public:
    Planner(const Scene& scene, const std::filesystem::path& directory)
        : scene_(scene), directory_(directory.empty() ? scene.directory : directory)
    {
    }

    void add(const TableRequest& request)
    {
        const SceneMaterial& material = scene_.materials[request.material];
        if (const auto* medium = std::get_if<LayeredMedium>(&material.made_of)) {
            check_amount(request, 1, product(material.sweeps));
            for (const auto& point : combinations(material.sweeps))
                keep(make_light_job(request, material,
                                    swept_layers(*medium, material.sweeps, point), point));
            return;
        }
        std::vector<Sweep> axes, files;
        for (const Sweep& sweep : material.sweeps) (sweep.axis ? axes : files).push_back(sweep);
        check_amount(request, product(axes), product(files));
        const auto* skin = std::get_if<Skin>(&material.made_of);
        for (const auto& point : combinations(files))
            keep(skin ? make_skin_job(request, *skin, files, point, axes)
                      : make_job(request, files, point, axes));
    }

    std::vector<Job> jobs() { return std::move(jobs_); }

private:
    void keep(Job job)
    {
        if (!names_.insert(job.name).second)
            throw UsageError(
                fmt::format("{}two tables would be written to `{}`", job.where, job.path.string()));
        jobs_.push_back(std::move(job));
    }

    Job make_light_job(const TableRequest& request, const SceneMaterial& material,
                       const LayeredMedium& medium, const std::vector<double>& point) const
    {
        Job job;
        job.name = request.name + name_of_layers(medium, material.sweeps, point);
        job.layers = LightJob{medium,        request.quantity, request.solver,
                              request.light, request.seed,     request.budget};
        Budget& budget = job.layers->budget;
        if (request.solver == "monte_carlo" && !budget.max_error && !budget.seconds &&
            !budget.photons)
            budget.photons = default_photons;
        job.must_reach = budget.max_error.has_value();
        set_storage(job, request);
        job.header =
            make_light_header(job, material.name, request.grid ? request.grid->axes : request.axes);
        located(job.where, [&] {
            check(job.header);
            if (job.header.quantity == "single_scattering_albedo")
                check_inversion(*job.layers, job.header.axes.front());
        });
        return job;
    }

    Job make_skin_job(const TableRequest& request, Skin skin, const std::vector<Sweep>& files,
                      const std::vector<double>& file_point, const std::vector<Sweep>& axes) const
    {
        Job job;
        job.name = request.name;
        for (std::size_t k = 0; k < files.size(); ++k) {
            skin.set(files[k].parameter, file_point[k]);
            job.name += fmt::format("-{}={}", files[k].parameter, file_point[k]);
        }
        set_storage(job, request);
        fill_skin(job, request, scene_.materials[request.material].name, skin, axes);
        located(job.where, [&] { check(job.header); });
        return job;
    }

    void set_storage(Job& job, const TableRequest& request) const
    {
        job.format = request.storage.format;
        job.write = request.storage.write;
        job.path = directory_ / (job.name + extension(job.format));
        job.where = request.where;
    }

    void check_amount(const TableRequest& request, std::size_t points, std::size_t files)
    {
        if (points > max_points || files > max_points || points * files > max_points - points_)
            throw UsageError(
                fmt::format("{}with the sweeps of this table there are more than {} "
                            "combinations in the scene",
                            request.where, max_points));
        points_ += points * files;
        if (files > max_files - jobs_.size())
            throw UsageError(fmt::format("{}with this table there are more than {} files",
                                         request.where, max_files));
    }

    Job make_job(const TableRequest& request, const std::vector<Sweep>& files,
                 const std::vector<double>& file_point, const std::vector<Sweep>& axes) const
    {
        const SceneMaterial& material = scene_.materials[request.material];
        const auto lobes =
            at_point(std::get<std::vector<Lobe>>(material.made_of), files, file_point);
        Job job;
        job.name = request.name;
        const auto prefixes = lobe_prefixes(lobes);
        for (std::size_t k = 0; k < files.size(); ++k)
            job.name +=
                fmt::format("-{}{}={}", prefixes[files[k].part], files[k].parameter, file_point[k]);
        set_storage(job, request);
        if (request.quantity->on_grid())
            fill_grid(job, request, lobes, axes);
        else
            fill_integral(job, request, lobes, axes);
        for (Material& point : job.materials) {
            point.name = material.name;
            point.ambient = material.ambient;
        }
        job.header = make_header(job, request, axes);
        located(job.where, [&] { check(job.header); });
        if (request.quantity->on_grid()) {
            check_frame(job);
            count_horizon(job);
        } else {
            for (const Material& point : job.materials)
                located(job.where, [&] { check_derived(job.header.quantity, point); });
        }
        return job;
    }

    static void fill_grid(Job& job, const TableRequest& request, const std::vector<Lobe>& lobes,
                          const std::vector<Sweep>& axes)
    {
        for (const auto& point : combinations(axes))
            job.materials.push_back({"", at_point(lobes, axes, point)});
        job.measure = request.quantity->id == "brdf_cosine" ? Measure::brdf_cosine : Measure::brdf;
        if (request.fit && request.budget.seconds) {
            job.fit = request.fit;
            job.seconds = request.budget.seconds;
            job.max_error = request.budget.max_error.value_or(0);
            job.must_reach = request.budget.max_error.has_value();
            job.grid = coarsest_grid(*request.fit);
        } else if (request.fit)
            fit_grid(job, *request.fit, *request.budget.max_error);
        else
            job.grid = *request.grid;
    }

    static void check_frame(const Job& job)
    {
        for (const Material& material : job.materials)
            if (job.grid.kind != GridKind::anisotropic && !material.isotropic())
                throw UsageError(fmt::format(
                    "{}material `{}` is anisotropic, and this grid has no tangent to tell its "
                    "directions apart; use kind = \"anisotropic\"",
                    job.where, material.name));
    }

    const Scene& scene_;
    std::filesystem::path directory_;
    std::vector<Job> jobs_;
    std::set<std::string> names_;
    std::size_t points_ = 0;
};

}  // namespace

std::vector<Job> plan_jobs(const Scene& scene, const std::filesystem::path& directory)
{
    Planner planner(scene, directory);
    for (const TableRequest& request : scene.tables) planner.add(request);
    return planner.jobs();
}

}  // namespace gonio
