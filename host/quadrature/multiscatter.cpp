// SPDX-License-Identifier: Apache-2.0
// What facets scatter more than once.
#include "quadrature/multiscatter.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "quadrature/derived.hpp"
#include "quadrature/rules.hpp"
#include "reference/fresnel.hpp"
#include "stopwatch.hpp"

namespace gonio {
namespace {

double lost(double albedo)
{
    return std::max(0.0, 1 - albedo);
}

}  // namespace

Material white_facets(const Material& material)
{
    Material result = material;
    Lobe& lobe = result.lobes.front();
    lobe.weight = {1.0};
    lobe.set("f0", std::vector{1.0});
    if (lobe.model->index_of("fresnel") != Model::npos) {
        lobe.set("fresnel", "schlick");
        for (const char* unused : {"eta", "k"}) {
            const std::size_t index = lobe.model->index_of(unused);
            lobe.values[index] = {lobe.model->parameters[index].preset};
        }
    }
    return result;
}

double mean_reflectance(const Lobe& lobe, std::size_t channel)
{
    const Model& model = *lobe.model;
    const auto number = [&](const char* name) {
        return lobe.number(model.index_of(name), channel);
    };
    const std::size_t fresnel = model.index_of("fresnel");
    const auto option = fresnel == Model::npos
                            ? "schlick"
                            : model.parameters[fresnel]
                                  .options[static_cast<std::size_t>(lobe.values[fresnel][0])]
                                  .name;
    if (option == "schlick") return number("f0") + (1 - number("f0")) / 21;
    const double eta = number("eta"), k = option == "conductor" ? number("k") : 0;
    // A less dense inside reflects all light up to here.
    const double critical = k == 0 && eta < 1 ? std::sqrt(1 - eta * eta) : 0;
    double sum = critical * critical;
    const reference::QuadratureRule& rule = rule_of(64);
    for (Eigen::Index n = 0; n < rule.nodes.size(); ++n) {
        const double u = rule.nodes[n], mu = critical + (1 - critical) * u * u;
        sum += rule.weights[n] * 2 * mu * (1 - critical) * 2 * u *
               reference::fresnel_exact(eta, k, mu);
    }
    return sum;
}

Albedos multiscatter_lobe(const Device& device, const Job& job)
{
    const std::vector<Material> facets = integrated_materials(job);
    // What is lost is divided by its mean, and errors with it.
    const double max_error = job.max_error / 4;
    const Stopwatch since;
    const double seconds = job.seconds.value_or(AlbedoOptions{}.seconds);
    const Albedos means = mean_albedos(device, facets, max_error, seconds / 2);
    // Each direction of a material once.
    std::map<std::pair<std::size_t, double>, std::size_t> place;
    for (const IntegralCell& cell : job.cells)
        for (const double cosine : {cell.at.cosine, cell.other_cosine})
            place.emplace(std::pair(cell.material, cosine), 0);
    std::vector<AlbedoCell> ends;
    for (auto& [end, index] : place) {
        index = ends.size();
        ends.push_back({end.first, {end.second, 0}});
    }
    const Albedos found = integrate_albedos(device, facets, ends,
                                            {Fixed::light, max_error, seconds - since.seconds()});

    Albedos lobe = found;
    const std::size_t channels = job.materials.front().channels();
    lobe.value.assign(channels, std::vector<double>(job.cells.size()));
    lobe.error = lobe.value;
    lobe.evaluated += means.evaluated;
    lobe.kernel_seconds += means.kernel_seconds;
    for (std::size_t k = 0; k < job.cells.size(); ++k) {
        const std::size_t m = job.cells[k].material;
        const std::size_t i = place.at({m, job.cells[k].at.cosine});
        const std::size_t o = place.at({m, job.cells[k].other_cosine});
        const double mean = means.value[0][m], mean_error = means.error[0][m];
        // Facets that lose nothing have no such lobe.
        if (lost(mean) <= 2 * mean_error) continue;
        const double lost_i = lost(found.value[0][i]), lost_o = lost(found.value[0][o]);
        const double unit = 1 / (std::numbers::pi * lost(mean));
        const double value = lost_i * lost_o * unit;
        const double error = unit * (found.error[0][i] * lost_o + lost_i * found.error[0][o]) +
                             value * mean_error / lost(mean);
        for (std::size_t c = 0; c < channels; ++c) {
            const Lobe& own = job.materials[m].lobes.front();
            const double f = mean_reflectance(own, c);
            const double factor =
                own.weight[own.weight.size() == 1 ? 0 : c] * f * f * mean / (1 - f * lost(mean));
            lobe.value[c][k] = factor * value;
            lobe.error[c][k] = factor * error;
        }
    }
    return lobe;
}

}  // namespace gonio
