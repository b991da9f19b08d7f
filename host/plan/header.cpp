// SPDX-License-Identifier: Apache-2.0
// Writes a job's parameters and conventions into its header.
#include "plan/header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "output/table_json.hpp"
#include "plan/fitted_grid.hpp"
#include "plan/grid_header.hpp"
#include "plan/integral_axes.hpp"
#include "plan/lobe_names.hpp"
#include "quadrature/derived.hpp"
#include "version.hpp"

namespace gonio {
namespace {

Attribute attribute(const std::vector<double>& numbers)
{
    if (numbers.size() == 1) return numbers.front();
    return numbers;
}

/// Adds the attributes of one header one by one.
class Attributes {
public:
    void add(const std::string& name, Attribute value)
    {
        all_.emplace_back(name, std::move(value));
    }

    /// Everything about a lobe but its swept parameters.
    void add(const Lobe& lobe, const std::string& prefix, const std::set<std::string>& swept)
    {
        const Model& model = *lobe.model;
        add(prefix + "model", std::string(model.id));
        add(prefix + "citation", std::string(model.citation));
        if (!swept.contains("weight") && (!prefix.empty() || lobe.weight != std::vector{1.0}))
            add(prefix + "weight", attribute(lobe.weight));
        for (std::size_t k = 0; k < model.parameters.size(); ++k) {
            const Parameter& parameter = model.parameters[k];
            const auto name = prefix + std::string(parameter.name);
            if (swept.contains(std::string(parameter.name))) continue;
            if (parameter.kind == Kind::choice) {
                const auto option = static_cast<std::size_t>(lobe.values[k].front());
                add(name, std::string(parameter.options[option].name));
                continue;
            }
            if (parameter.kind == Kind::table) {
                const auto grid = lobe.table(k);
                add(name, grid ? grid->name : std::string("none"));
                if (grid) add(name + ".digest", grid->digest);
                continue;
            }
            add(name, attribute(lobe.values[k]));
            if (parameter.unit != "1") add(name + ".unit", std::string(parameter.unit));
        }
    }

    std::vector<std::pair<std::string, Attribute>> all() { return std::move(all_); }

private:
    std::vector<std::pair<std::string, Attribute>> all_;
};

std::string conversion_text(const Job& job)
{
    const bool printed = std::ranges::any_of(
        job.materials.front().lobes, [](const Lobe& lobe) { return (lobe.traits() & VALUE) != 0; });
    if (!printed || job.measure != Measure::brdf) return {};
    return "the paper's value holds cos theta_i and is divided by it";
}

}  // namespace

std::string storage_text(const Job& job)
{
    if (job.format != "exr") return job.format;
    return fmt::format("exr, {}, {}", job.write.half ? "half" : "float", job.write.compression);
}

TableHeader make_header(const Job& job, const TableRequest& request,
                        const std::vector<Sweep>& swept)
{
    const Quantity& quantity = *request.quantity;
    const Material& material = job.materials.front();
    TableHeader header;
    header.quantity = quantity.id;
    header.unit = quantity.unit;
    for (const Sweep& sweep : swept) header.axes.push_back(sweep_axis(sweep, material.lobes));
    header.sweep_axes = swept.size();
    const std::vector<Axis>& own = quantity.on_grid() ? job.grid.axes : request.axes;
    header.axes.insert(header.axes.end(), own.begin(), own.end());
    // The innermost axis is never a swept one.
    if (own.empty() && !swept.empty()) --header.sweep_axes;
    header.channels =
        quantity.on_grid() ? material.channel_names() : derived_channels(header.quantity, material);

    Attributes attributes;
    attributes.add("program", std::string(GONIO_PROGRAM));
    attributes.add("title", std::string(quantity.title));
    attributes.add("solver", request.solver);
    attributes.add("storage", storage_text(job));
    if (quantity.on_grid()) {
        attributes.add("grid", grid_name(job.grid.kind));
        attributes.add("directions", directions_text(job.grid.kind));
        if (request.fit) {
            attributes.add("interpolation",
                           fmt::format("{}, to {} deg from the normal",
                                       request.fit->cubic ? "cubic" : "linear", fitted_theta));
            if (job.max_error > 0) attributes.add("interpolation.max_error", job.max_error);
            attributes.add("interpolation.error", job.interpolation_error);
        }
    } else {
        if (job.max_error > 0) attributes.add("max_error", job.max_error);
        attributes.add("directions",
                       std::string("normal +z, tangent +x; mu is the cosine between a "
                                   "direction and the normal"));
    }
    if (job.seconds) {
        attributes.add("time", *job.seconds);
        attributes.add("time.unit", std::string("s"));
    }
    if (const auto cells = cells_at_the_horizon(job.grid); cells != 0) {
        attributes.add("horizon", std::string("cells with a direction at 90 deg hold the limit "
                                              "there, or 0 where it is infinite"));
        attributes.add("horizon.cells", static_cast<double>(cells));
    }
    if (const auto text = conversion_text(job); !text.empty()) attributes.add("conversion", text);
    attributes.add("material", material.name);
    if (!material.ambient.empty()) attributes.add("ambient", attribute(material.ambient));
    const auto prefixes = lobe_prefixes(material.lobes);
    std::vector<Sweep> varied = swept;
    for (const Axis& axis : request.axes)
        if (const auto parameter = parameter_of(material.lobes, axis.name))
            varied.push_back(*parameter);
    for (std::size_t k = 0; k < material.lobes.size(); ++k) {
        std::set<std::string> names;
        for (const Sweep& sweep : varied)
            if (sweep.part == k)
                for (const auto& name : parameters_of(*material.lobes[k].model, sweep.parameter))
                    names.insert(name);
        attributes.add(material.lobes[k], prefixes[k], names);
    }
    header.attributes = attributes.all();
    return header;
}

std::string definition(const Job& job)
{
    return text_of(to_json(job.header));
}

}  // namespace gonio
