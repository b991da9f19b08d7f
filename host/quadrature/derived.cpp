// SPDX-License-Identifier: Apache-2.0
// Quantities that are made of albedos.
#include "quadrature/derived.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "gonio/errors.hpp"
#include "quadrature/multiscatter.hpp"

namespace gonio {
namespace {

bool is_split_sum(const std::string& quantity)
{
    return quantity.starts_with("dfg");
}

/// Has the lobe such a choice, and is it another option than this?
bool has_other_option(const Lobe& lobe, std::string_view choice, std::string_view option)
{
    const std::size_t index = lobe.model->index_of(choice);
    if (index == Model::npos) return false;
    const auto chosen = static_cast<std::size_t>(lobe.values[index].front());
    return lobe.model->parameters[index].options[chosen].name != option;
}

double seconds_of(const Job& job)
{
    return job.seconds.value_or(AlbedoOptions{}.seconds);
}

/// Albedos of cells in any order.
Albedos integrate(const Device& device, const std::vector<Material>& materials,
                  const std::vector<IntegralCell>& cells, const AlbedoOptions& options)
{
    std::vector<std::size_t> order(cells.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t k) { return cells[k].material; });
    std::vector<AlbedoCell> sorted;
    for (const std::size_t k : order) sorted.push_back({cells[k].material, cells[k].at});
    Albedos found = integrate_albedos(device, materials, sorted, options);
    for (auto* planes : {&found.value, &found.error})
        for (auto& plane : *planes) {
            std::vector<double> in_place(plane.size());
            for (std::size_t k = 0; k < order.size(); ++k) in_place[order[k]] = plane[k];
            plane = std::move(in_place);
        }
    return found;
}

Albedos means_of_cells(const Device& device, const Job& job)
{
    Albedos means = mean_albedos(device, job.materials, job.max_error, seconds_of(job));
    for (auto* planes : {&means.value, &means.error})
        for (auto& plane : *planes) {
            std::vector<double> of_cells;
            for (const IntegralCell& cell : job.cells) of_cells.push_back(plane[cell.material]);
            plane = std::move(of_cells);
        }
    return means;
}

/// Schlick's reflectance is linear in f0, so two channels with f0 = 1 and f0 = 0 say all.
Albedos split_sum(const Device& device, const Job& job, bool multiscatter)
{
    Albedos all =
        integrate(device, integrated_materials(job), job.cells,
                  {Fixed::viewer, job.max_error / (multiscatter ? 1 : 2), seconds_of(job)});
    if (multiscatter) {
        std::swap(all.value[0], all.value[1]);
        std::swap(all.error[0], all.error[1]);
        return all;
    }
    for (std::size_t k = 0; k < job.cells.size(); ++k) {
        all.value[0][k] -= all.value[1][k];
        all.error[0][k] += all.error[1][k];
    }
    return all;
}

/// In double, so that what is left is the rounding to float.
Albedos specular(const Job& job)
{
    const std::size_t channels = job.materials.front().channels();
    Albedos all;
    for (std::size_t c = 0; c < channels; ++c) {
        std::vector<double> values, errors;
        for (const IntegralCell& cell : job.cells) {
            values.push_back(
                specular_reflectance(job.materials[cell.material], unit_vector(cell.at), c));
            errors.push_back(values.back() * 0x1p-24);
        }
        all.value.push_back(std::move(values));
        all.error.push_back(std::move(errors));
    }
    return all;
}

Albedos albedos_of(const Device& device, const Job& job)
{
    const std::string& quantity = job.header.quantity;
    if (is_split_sum(quantity)) return split_sum(device, job, quantity == "dfg_multiscatter");
    if (quantity == "specular_reflectance") return specular(job);
    if (quantity == "mean_albedo") return means_of_cells(device, job);
    if (quantity == "kulla_conty") return multiscatter_lobe(device, job);
    const bool viewer = quantity == "hemispherical_directional_reflectance";
    return integrate(device, job.materials, job.cells,
                     {viewer ? Fixed::viewer : Fixed::light, job.max_error, seconds_of(job)});
}

void check_mirror_term(const Material& material)
{
    std::vector<std::string_view> models;
#define SPECULAR(id) models.emplace_back(#id);
#include "gonio/shared/models.inc"
    const bool has_one = std::ranges::any_of(material.lobes, [&](const Lobe& lobe) {
        return std::ranges::find(models, lobe.model->id) != models.end();
    });
    if (!has_one)
        throw UsageError(
            fmt::format("no lobe of material `{}` has a mirror term; models that have one: {}",
                        material.name, fmt::join(models, ", ")));
}

}  // namespace

std::vector<Material> integrated_materials(const Job& job)
{
    std::vector<Material> materials = job.materials;
    for (Material& material : materials) {
        if (job.header.quantity == "kulla_conty") material = white_facets(material);
        if (!is_split_sum(job.header.quantity)) continue;
        for (Lobe& lobe : material.lobes) lobe.set("f0", std::vector{1.0, 0.0});
    }
    return materials;
}

std::vector<std::string> derived_channels(const std::string& quantity, const Material& material)
{
    std::vector<std::string> channels = material.channel_names();
    if (quantity == "dfg") channels = {"scale", "bias"};
    if (quantity == "dfg_multiscatter") channels = {"bias", "albedo"};
    const std::size_t count = channels.size();
    for (std::size_t c = 0; c < count; ++c) channels.push_back(channels[c] + ".error");
    return channels;
}

void check_derived(const std::string& quantity, const Material& material)
{
    if (quantity == "specular_reflectance") return check_mirror_term(material);
    if (!is_split_sum(quantity) && quantity != "kulla_conty") return;
    for (const Lobe& lobe : material.lobes) {
        const auto refuse = [&](std::string_view why) {
            throw UsageError(fmt::format("the quantity `{}` of material `{}`: {}", quantity,
                                         material.name, why));
        };
        if (lobe.model->index_of("f0") == Model::npos)
            refuse(fmt::format("the model `{}` has no facets with an f0", lobe.model->id));
        if (!material.isotropic()) refuse("it needs the same roughness along x and y");
        if (quantity == "kulla_conty" && material.lobes.size() != 1)
            refuse("it is of one lobe, not of a sum");
        if (is_split_sum(quantity) && has_other_option(lobe, "fresnel", "schlick"))
            refuse("it needs fresnel = \"schlick\"");
        if (is_split_sum(quantity) && lobe.weight.size() != 1) refuse("its weight is one number");
    }
}

DerivedTable derive(const Device& device, const Job& job)
{
    DerivedTable table;
    table.spent = albedos_of(device, job);
    for (auto* planes : {&table.spent.value, &table.spent.error})
        for (auto& plane : *planes) table.values.push_back(std::move(plane));
    const std::size_t channels = table.values.size() / 2;
    for (std::size_t c = channels; c < table.values.size(); ++c)
        for (std::size_t k = 0; k < job.cells.size(); ++k)
            table.largest_error = std::max(
                table.largest_error,
                table.values[c][k] / std::max(1.0, std::abs(table.values[c - channels][k])));
    return table;
}

}  // namespace gonio
