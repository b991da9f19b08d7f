// SPDX-License-Identifier: Apache-2.0
// What a model is verified on: parameters and directions, random and extreme.
#include "verify/cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace gonio {
namespace {

using Generator = std::mt19937_64;

double uniform(Generator& random, double from, double to)
{
    // Not std::uniform_real_distribution, whose numbers differ between standard libraries.
    return from + (to - from) * (static_cast<double>(random() >> 11) * 0x1p-53);
}

/// Over a range of many orders of magnitude, evenly in the logarithm.
double random_number(Generator& random, const Parameter& parameter)
{
    const double least = parameter.least, greatest = parameter.greatest;
    if (least > 0 && greatest / least > 100)
        return least * std::pow(greatest / least, uniform(random, 0, 1));
    if (least == 0 && greatest > 100) return std::pow(greatest + 1, uniform(random, 0, 1)) - 1;
    return uniform(random, least, greatest);
}

void set_number(Lobe& lobe, std::size_t index, double number)
{
    lobe.values[index] = {std::clamp(number, lobe.model->parameters[index].least,
                                     lobe.model->parameters[index].greatest)};
}

void set_residual(Lobe& lobe, std::size_t index, Spacing spacing)
{
    lobe.tables.resize(lobe.values.size());
    lobe.tables[index] = verification_residual(spacing, 1);
}

/// Angles of a grid axis, ascending and distinct.
std::vector<double> sorted(std::vector<double> values)
{
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

std::vector<double> polar_values(Generator& random, std::size_t count, bool offsets)
{
    const double grazing = 90 - 1e-6 * 180 / 3.14159265358979;
    std::vector<double> values{0, 1e-5, 1e-2, 20, 45, 60, 88, 89.9, 89.999, grazing};
    for (std::size_t k = 0; k < count; ++k) values.push_back(uniform(random, 0, 90));
    if (offsets) {
        // Next to the mirror direction of those above, at every scale of a highlight.
        const std::size_t size = values.size();
        for (std::size_t k = 0; k < size; ++k)
            values.push_back(
                std::clamp(values[k] + std::pow(10.0, uniform(random, -6, 1)), 0.0, grazing));
    }
    return sorted(std::move(values));
}

std::vector<double> azimuth_values(Generator& random, std::size_t count)
{
    std::vector<double> values{0, 1e-4, 90, 179, 180 - 1e-2, 180 - 1e-4, 180, 180 + 1e-3, 270, 359};
    for (std::size_t k = 0; k < count; ++k) {
        values.push_back(uniform(random, 0, 360));
        values.push_back(180 - std::pow(10.0, uniform(random, -5, 1)));
    }
    return sorted(std::move(values));
}

}  // namespace

std::vector<Lobe> single_variants(const Model& model)
{
    std::vector<Lobe> all{default_lobe(model.id)};
    for (std::size_t k = 0; k < model.parameters.size(); ++k)
        for (std::size_t option = 0; option < model.parameters[k].options.size(); ++option) {
            if (all[0].values[k][0] == static_cast<double>(option)) continue;
            all.push_back(all[0]);
            all.back().values[k] = {static_cast<double>(option)};
        }
    return all;
}

std::vector<Lobe> all_variants(const Model& model)
{
    std::vector<Lobe> all{default_lobe(model.id)};
    for (std::size_t k = 0; k < model.parameters.size(); ++k) {
        if (model.parameters[k].kind != Kind::choice) continue;
        std::vector<Lobe> more;
        for (const Lobe& lobe : all)
            for (std::size_t option = 0; option < model.parameters[k].options.size(); ++option) {
                more.push_back(lobe);
                more.back().values[k] = {static_cast<double>(option)};
            }
        all = std::move(more);
    }
    return all;
}

std::shared_ptr<const ResidualGrid> verification_residual(Spacing spacing, std::size_t channels)
{
    const bool merl = spacing == Spacing::merl;
    const Grid grid =
        rusinkiewicz_grid(24, 16, 30, merl ? Samples::centre : Samples::node, spacing);
    Table table;
    table.header.quantity = residual_quantity;
    table.header.axes = grid.axes;
    Generator random(20090101);
    for (std::size_t c = 0; c < channels; ++c) {
        table.header.channels.push_back(std::string(1, static_cast<char>('a' + c)));
        auto& plane = table.values.emplace_back(table.header.cells());
        for (double& value : plane) value = uniform(random, -1, 1);
    }
    return std::make_shared<const ResidualGrid>(residual_of(table, "noise"));
}

std::vector<Material> verification_materials(const Model& model, bool quick)
{
    Generator random(20220301);
    const std::size_t count = quick ? 2 : 16;
    std::vector<Material> all;
    for (const Lobe& variant : quick ? single_variants(model) : all_variants(model)) {
        all.push_back({std::string(model.id), {variant}});
        for (std::size_t k = 0; k < model.parameters.size(); ++k) {
            if (!model.parameters[k].is_number()) continue;
            for (const double end : {model.parameters[k].least, model.parameters[k].greatest}) {
                all.push_back({std::string(model.id), {variant}});
                set_number(all.back().lobes[0], k, end);
            }
        }
        for (std::size_t n = 0; n < count; ++n) {
            all.push_back({std::string(model.id), {variant}});
            Lobe& lobe = all.back().lobes[0];
            for (std::size_t k = 0; k < model.parameters.size(); ++k)
                if (model.parameters[k].is_number())
                    set_number(lobe, k, random_number(random, model.parameters[k]));
                else if (model.parameters[k].kind == Kind::table && n % 2 == 0)
                    set_residual(lobe, k, n % 4 == 0 ? Spacing::merl : Spacing::linear);
            // Every other one isotropic, so that the program without a tangent frame is verified
            // too.
            for (const Both& both : model.both)
                if (n % 2 == 0)
                    lobe.values[model.index_of(both.second)] =
                        lobe.values[model.index_of(both.first)];
        }
    }
    return all;
}

Grid verification_grid(const Material& material, std::size_t count)
{
    Generator random(19940714);
    const auto axis = [](const char* name, std::vector<double> values) {
        return Axis{name, "deg", std::move(values), Samples::node};
    };
    Grid grid;
    grid.kind = material.isotropic() ? GridKind::isotropic : GridKind::anisotropic;
    grid.axes.push_back(axis("theta_i", polar_values(random, count, false)));
    if (!material.isotropic()) grid.axes.push_back(axis("phi_i", {0, 33, 90, 211}));
    grid.axes.push_back(axis("theta_o", polar_values(random, count, true)));
    grid.axes.push_back(
        axis(material.isotropic() ? "delta_phi" : "phi_o", azimuth_values(random, count)));
    return grid;
}

Grid verification_half_grid(std::size_t count)
{
    Generator random(19980629);
    std::vector<double> half{1e-6, 1e-4, 1e-2, 1, 30, 60, 85};
    std::vector<double> difference{0, 1e-4, 20, 45, 70, 89, 89.99};
    for (std::size_t k = 0; k < count; ++k) {
        half.push_back(std::pow(10.0, uniform(random, -5, 1.9)));
        difference.push_back(uniform(random, 0, 90));
    }
    return {GridKind::rusinkiewicz,
            {{"theta_h", "deg", sorted(std::move(half)), Samples::node},
             {"theta_d", "deg", sorted(std::move(difference)), Samples::node},
             {"phi_d", "deg", azimuth_values(random, count), Samples::node}}};
}

std::vector<DirectionPair> verification_pairs(std::size_t count)
{
    Generator random(19920726);
    std::vector<DirectionPair> pairs;
    const std::vector<double> theta = polar_values(random, 0, false);
    for (const double i : theta)
        for (const double o : theta)
            for (const double phi : {0.0, 77.0, 180.0}) pairs.push_back({i, 12, o, 12 + phi});
    for (std::size_t k = 0; k < count; ++k) {
        const double i = uniform(random, 0, 90), phi = uniform(random, 0, 360);
        const double away = std::pow(10.0, uniform(random, -6, 2));
        pairs.push_back({i, phi, std::clamp(i + away, 0.0, 89.9999), phi + 180 + away});
        pairs.push_back({i, phi, uniform(random, 0, 90), uniform(random, 0, 360)});
    }
    return pairs;
}

std::string parameter_text(const Lobe& lobe)
{
    std::string text;
    for (std::size_t k = 0; k < lobe.values.size(); ++k) {
        const Parameter& parameter = lobe.model->parameters[k];
        if (!text.empty()) text += ", ";
        if (parameter.kind == Kind::choice)
            text +=
                fmt::format("{} = {}", parameter.name,
                            parameter.options[static_cast<std::size_t>(lobe.values[k][0])].name);
        else if (parameter.kind == Kind::table)
            text += fmt::format("{} = {}", parameter.name,
                                lobe.table(k) ? lobe.table(k)->name : "none");
        else
            text += fmt::format("{} = {:.6g}", parameter.name, lobe.values[k][0]);
    }
    return text;
}

}  // namespace gonio
