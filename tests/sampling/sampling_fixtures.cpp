// SPDX-License-Identifier: Apache-2.0
// Materials that can be sampled, each with lights, and the agreement of samples with a density.
#include "sampling/sampling_fixtures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unsupported/Eigen/SpecialFunctions>

#include "grid/angles.hpp"
#include "reference/gauss_legendre.hpp"
#include "verify/cases.hpp"

namespace gonio::test {
namespace {

using std::numbers::pi;

/// From the narrowest lobe, 0, to a broad one, 1: evenly in the logarithm of a roughness, or of an
/// exponent down to 1, since that of 0 has a step at its edge, which no rule integrates.
double at_breadth(const Parameter& parameter, double part)
{
    if (parameter.least > 0)
        return parameter.least * std::pow(parameter.greatest / parameter.least, part);
    return std::pow(parameter.greatest, 1 - part);
}

double at_end(const Parameter& parameter, double part)
{
    return part == 0 ? parameter.least : parameter.greatest;
}

/// number: of a parameter and a part of its range; of the second of two parameters that have a
/// common name, `second`.
Material with_numbers(const Lobe& variant, double first, double second,
                      double (*number)(const Parameter&, double) = at_breadth)
{
    Lobe lobe = variant;
    for (std::size_t k = 0; k < lobe.values.size(); ++k) {
        const Parameter& parameter = lobe.model->parameters[k];
        if (parameter.kind != Kind::scalar) continue;
        const bool is_second = std::ranges::any_of(
            lobe.model->both, [&](const Both& both) { return both.second == parameter.name; });
        lobe.values[k] = {number(parameter, is_second ? second : first)};
    }
    return {std::string(variant.model->id), {lobe}};
}

SamplingCase named(const Material& material, double theta_i, double phi_i)
{
    return {fmt::format("{} {} at {}, {}", material.name, parameter_text(material.lobes[0]),
                        theta_i, phi_i),
            material, theta_i, phi_i};
}

/// Edges between which equal parts of the values lie, and further ones out to the ends, so that a
/// bin is at most thrice as wide as the next.
std::vector<double> edges_of(std::vector<double> values, double end)
{
    constexpr std::size_t parts = 10;
    std::ranges::sort(values);
    std::vector<double> edges{0};
    for (std::size_t k = 1; k < parts; ++k) edges.push_back(values[k * values.size() / parts]);
    edges.push_back(end);
    for (std::size_t k = 0; k + 1 < edges.size();) {
        const auto width = [&](std::size_t bin) { return edges[bin + 1] - edges[bin]; };
        const auto at = edges.begin() + static_cast<std::ptrdiff_t>(k) + 1;
        if (k > 0 && width(k) > 3 * width(k - 1)) {
            edges.insert(at, edges[k] + 2 * width(k - 1));
        } else if (k + 2 < edges.size() && width(k) > 3 * width(k + 1)) {
            edges.insert(at, edges[k + 1] - 2 * width(k + 1));
            continue;
        }
        ++k;
    }
    return edges;
}

/// theta_o, and phi_o - phi_i in [0, 2 pi).
struct Place {
    double theta, phi;
};

Place place_of(const glm::dvec3& v, double phi_i)
{
    const double phi = std::atan2(v.y, v.x) - phi_i * pi / 180;
    return {std::atan2(std::hypot(v.x, v.y), v.z), phi - 2 * pi * std::floor(phi / (2 * pi))};
}

/// Bins in theta_o and phi_o, and what is expected in each.
class Histogram {
public:
    Histogram(const ViewerSamples& samples, double phi_i) : phi_i_(phi_i)
    {
        std::vector<double> theta, phi;
        for (const glm::vec3& v : samples.viewer) {
            if (v.z <= 0) continue;
            const Place at = place_of(v, phi_i);
            theta.push_back(at.theta);
            phi.push_back(at.phi);
        }
        theta_ = edges_of(std::move(theta), pi / 2);
        phi_ = edges_of(std::move(phi), 2 * pi);
    }

    std::size_t size() const { return (theta_.size() - 1) * (phi_.size() - 1); }

    std::size_t bin_of(const glm::dvec3& v) const
    {
        const Place at = place_of(v, phi_i_);
        return place_in(theta_, at.theta) * (phi_.size() - 1) + place_in(phi_, at.phi);
    }

    /// The integral of a density over each bin.
    template <class Density>
    std::vector<double> integrals(const Density& density) const
    {
        const Nodes theta(theta_), phi(phi_);
        std::vector<glm::dvec3> viewers;
        for (const double t : theta.at)
            for (const double p : phi.at) {
                const double azimuth = p + phi_i_ * pi / 180;
                viewers.emplace_back(std::sin(t) * std::cos(azimuth),
                                     std::sin(t) * std::sin(azimuth), std::cos(t));
            }
        const std::vector<float> values = density(viewers);
        std::vector<double> sums(size());
        for (std::size_t i = 0; i < theta.at.size(); ++i)
            for (std::size_t j = 0; j < phi.at.size(); ++j)
                sums[i / order * (phi_.size() - 1) + j / order] +=
                    theta.weight[i] * std::sin(theta.at[i]) * phi.weight[j] *
                    static_cast<double>(values[i * phi.at.size() + j]);
        return sums;
    }

private:
    static constexpr int order = 6;

    struct Nodes {
        std::vector<double> at, weight;

        explicit Nodes(const std::vector<double>& edges)
        {
            const reference::QuadratureRule rule = reference::gauss_legendre(order);
            for (std::size_t k = 0; k + 1 < edges.size(); ++k)
                for (Eigen::Index n = 0; n < order; ++n) {
                    at.push_back(edges[k] + (edges[k + 1] - edges[k]) * rule.nodes[n]);
                    weight.push_back((edges[k + 1] - edges[k]) * rule.weights[n]);
                }
        }
    };

    static std::size_t place_in(const std::vector<double>& edges, double value)
    {
        const auto above = std::upper_bound(edges.begin() + 1, edges.end() - 1, value);
        return static_cast<std::size_t>(above - edges.begin()) - 1;
    }

    double phi_i_;
    std::vector<double> theta_, phi_;
};

}  // namespace

Incidence SamplingCase::light() const
{
    return {cosine_of_degrees(theta_i), phi_i};
}

std::vector<Lobe> sampled_variants(const Model& model)
{
    std::vector<Lobe> all = all_variants(model);
    const std::size_t fresnel = model.index_of("fresnel");
    if (fresnel != Model::npos)
        std::erase_if(all, [&](const Lobe& lobe) { return lobe.values[fresnel][0] != 0; });
    return all;
}

std::vector<SamplingCase> sampling_cases(const Lobe& variant)
{
    const Material defaults{std::string(variant.model->id), {variant}};
    const Material brushed = with_numbers(variant, 0.75, 0.95);
    return {named(defaults, 60, 30),
            named(defaults, 89, 0),
            named(with_numbers(variant, 0.5, 0.5), 35, 200),
            named(brushed, 0, 0),
            named(brushed, 50, 25),
            named(with_numbers(variant, 1, 1), 80, 110)};
}

std::vector<SamplingCase> extreme_cases(const Lobe& variant)
{
    std::vector<SamplingCase> all;
    for (const double first : {0.0, 1.0})
        for (const double second : {0.0, 1.0})
            for (const double theta_i : {0.0, 1e-4, 45.0, 89.9, 90 - 1e-4})
                all.push_back(named(with_numbers(variant, first, second, at_end), theta_i, 20));
    return all;
}

double probability_of_histogram(
    const ViewerSamples& samples, const ViewerSamples& others, double phi_i,
    const std::function<std::vector<float>(const std::vector<glm::dvec3>&)>& density)
{
    const Histogram bins(others, phi_i);
    std::vector<double> expected = bins.integrals(density);
    double above = 0;
    for (const double part : expected) above += part;
    expected.push_back(1 - above);
    std::vector<double> found(expected.size());
    for (const glm::vec3& v : samples.viewer) found[v.z <= 0 ? bins.size() : bins.bin_of(v)] += 1;

    const auto count = static_cast<double>(samples.viewer.size());
    double chi_squared = 0, degrees = -1, rare_expected = 0, rare_found = 0;
    const auto compare = [&](double of, double with) {
        chi_squared += (of - with) * (of - with) / with;
        degrees += 1;
    };
    for (std::size_t k = 0; k < expected.size(); ++k)
        if (count * expected[k] < 5) {
            rare_expected += count * expected[k];
            rare_found += found[k];
        } else {
            compare(found[k], count * expected[k]);
        }
    // Fewer than five of all: as good as impossible are more than thirty.
    if (rare_expected >= 5) compare(rare_found, rare_expected);
    if (rare_expected < 5 && rare_found > 30) return 0;
    return Eigen::numext::igammac(degrees / 2, chi_squared / 2);
}

}  // namespace gonio::test
