// SPDX-License-Identifier: Apache-2.0
// Plans tables of skin.
#include "plan/skin_job.hpp"

#include "plan/header.hpp"
#include "skin/profile_table.hpp"
#include "skin/skin_sets.hpp"

namespace gonio {

void fill_skin(Job& job, const TableRequest& request, const std::string& material, const Skin& skin,
               const std::vector<Sweep>& axes)
{
    const Quantity& quantity = *request.quantity;
    const bool traced = request.solver == "monte_carlo";
    SkinTask task{.skin = skin,
                  .ladders = {},
                  .wavelengths = traced ? std::vector<double>() : wavelengths_of(request),
                  .light = request.light,
                  .tolerance = request.budget.max_error.value_or(1e-4)};
    for (const Sweep& sweep : axes) task.ladders.push_back({sweep.parameter, sweep.values});
    job.header = traced ? profile_header(task, request) : skin_header(task, quantity, request.axes);
    job.header.single_precision = job.format == "exr";
    auto& attributes = job.header.attributes;
    attributes.emplace_back("title", std::string(quantity.title));
    attributes.emplace_back("storage", storage_text(job));
    attributes.emplace_back("material", material);
    if (traced) {
        job.profile = profile_request(request);
        job.must_reach = job.profile->max_error || job.profile->ring_error;
        if (job.profile->seconds)
            *job.profile->seconds /= static_cast<double>(sets_of(task).size());
    }
    job.skin = std::move(task);
}

}  // namespace gonio
