// SPDX-License-Identifier: Apache-2.0
// Directional albedo by products of Gauss rules, for tests of closed forms and tables.
#include "reference/albedo_fixtures.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>

#include "reference/gauss_legendre.hpp"

namespace gonio {
namespace {

using std::numbers::pi;

/// The integral of f from a to b.
template <class Function>
double integral(double a, double b, int nodes, Function f)
{
    static std::map<int, reference::QuadratureRule> rules;
    auto& rule = rules[nodes];
    if (rule.nodes.size() == 0) rule = reference::gauss_legendre(nodes);
    double sum = 0;
    for (int k = 0; k < nodes; ++k) sum += rule.weights[k] * f(a + (b - a) * rule.nodes[k]);
    return (b - a) * sum;
}

/// The same for integrands that begin and end like roots.
template <class Function>
double integral_with_soft_ends(double a, double b, int nodes, Function f)
{
    return integral(0, 1, nodes, [&](double u) {
        const double sine = std::sin(pi * u / 2);
        return f(a + (b - a) * sine * sine) * (b - a) * pi / 2 * std::sin(pi * u);
    });
}

}  // namespace

double albedo(const Brdf& f, double mu, int nodes)
{
    const glm::dvec3 l = direction_of_cosine(mu, 0);
    const double theta_i = std::atan2(l.x, l.z);
    const auto ring = [&](double theta) {
        const auto at = [&](double phi) {
            return f(l, {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                         std::cos(theta)});
        };
        const double near = integral(0, pi / 2, nodes, at), far = integral(pi / 2, pi, nodes, at);
        return 2 * (near + far) * std::cos(theta) * std::sin(theta);
    };
    return integral_with_soft_ends(0, theta_i, nodes, ring) +
           integral_with_soft_ends(theta_i, pi / 2, nodes, ring);
}

double albedo_over_half_vectors(const Brdf& f, double mu, double alpha, int nodes)
{
    const glm::dvec3 l = direction_of_cosine(mu, 0);
    const double theta_i = std::atan2(l.x, l.z);
    // t = asinh(tan theta_h/alpha) spreads core and tail alike.
    const auto ring = [&](double t) {
        const double tan = alpha * std::sinh(t), cos = 1 / std::sqrt(1 + tan * tan);
        const double sin = tan * cos;
        const auto at = [&](double phi) {
            const glm::dvec3 h(sin * std::cos(phi), sin * std::sin(phi), cos);
            const double l_h = glm::dot(l, h);
            const glm::dvec3 v = 2 * l_h * h - l;
            return v.z > 0 ? f(l, v) * v.z * 4 * l_h : 0;
        };
        // v sets, and the masking of grooves changes hands, where l.h is one of these.
        std::array ends{2 * mu * cos, mu / cos, 2 * mu * cos / std::abs(4 * cos * cos - 1),
                        mu / (2 * cos)};
        for (double& end : ends)
            end = std::acos(std::clamp((end - mu * cos) / (l.x * sin), -1.0, 1.0));
        std::sort(ends.begin(), ends.end() - 1);
        double sum = 0, from = 0;
        for (const double end : ends) {
            const double to = std::min(end, ends.back());
            if (to > from) sum += integral(from, to, nodes, at);
            from = std::max(from, to);
        }
        return 2 * sum * sin * alpha * std::cosh(t) * cos * cos;
    };
    // In the plane of incidence the same happens at these theta_h.
    const double down = pi / 2 - theta_i, up = pi / 2 + theta_i;
    std::array ends{down / 3, down / 2, up / 3, down, theta_i, pi / 4, up / 2};
    std::ranges::sort(ends);
    double sum = 0, from = 0;
    for (const double end : ends) {
        const double to = std::asinh(std::tan(std::min(end, up / 2)) / alpha);
        if (to > from) sum += integral_with_soft_ends(from, to, nodes, ring);
        from = to;
    }
    return sum;
}

double mean_albedo(const std::function<double(double mu)>& directional, int nodes)
{
    return integral(0, 1, nodes, [&](double u) {
        const double mu = u * u * u;
        return 2 * directional(mu) * mu * 3 * u * u;
    });
}

}  // namespace gonio
