// SPDX-License-Identifier: Apache-2.0
// Directional albedo in double, by adaptive Gauss rules in the angles of the outgoing direction.
#include "reference/albedo.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "reference/gauss_legendre.hpp"

namespace gonio::reference {
namespace {

using std::numbers::pi;

constexpr int nodes = 10, deepest = 12;
/// An integral is as exact as its tolerance, or as this part of the tolerance times itself: a
/// narrow lobe's peak is 1/alpha^2.
constexpr double of_itself = 0.1;

struct Tolerance {
    double absolute, relative;

    bool holds(double difference, double value) const
    {
        return std::abs(difference) <= absolute + relative * std::abs(value);
    }
    Tolerance shared(double parts) const { return {absolute / parts, relative}; }
};

/// The integral of f from a to b by one rule.
template <class Function>
double gauss(double a, double b, const Function& f)
{
    static const QuadratureRule rule = gauss_legendre(nodes);
    double sum = 0;
    for (int k = 0; k < nodes; ++k) sum += rule.weights[k] * f(a + (b - a) * rule.nodes[k]);
    return (b - a) * sum;
}

template <class Function>
double halved(double a, double b, double whole, Tolerance tolerance, int depth, const Function& f)
{
    const double middle = (a + b) / 2;
    const double left = gauss(a, middle, f), right = gauss(middle, b, f);
    const double sum = left + right;
    if (tolerance.holds(sum - whole, sum) || depth == deepest) return sum;
    return halved(a, middle, left, tolerance.shared(2), depth + 1, f) +
           halved(middle, b, right, tolerance.shared(2), depth + 1, f);
}

/// Panel by panel between the breaks that lie between a and b.
template <class Function>
double adaptive(double a, double b, std::vector<double> breaks, Tolerance tolerance,
                const Function& f)
{
    std::erase_if(breaks, [&](double at) { return !(at > a && at < b); });
    breaks.push_back(b);
    std::ranges::sort(breaks);
    double sum = 0, from = a;
    for (const double to : breaks) {
        const Tolerance share = tolerance.shared(static_cast<double>(breaks.size()));
        sum += halved(from, to, gauss(from, to, f), share, 0, f);
        from = to;
    }
    return sum;
}

/// An angle and its surroundings at every scale of a highlight.
std::vector<double> around(double angle, double scale)
{
    std::vector<double> breaks{angle};
    for (double away = 0.3; away > 1e-6; away /= 8)
        for (const double sign : {-1.0, 1.0}) breaks.push_back(angle + sign * away * scale);
    return breaks;
}

/// The integral of g(w) w.z over all w; g is narrow, if it is, about the mirror direction of
/// `fixed`.
template <class Function>
double over_hemisphere(glm::dvec3 fixed, double exact_to, const Function& g)
{
    const double sine = std::hypot(fixed.x, fixed.y), theta = std::atan2(sine, fixed.z);
    const double azimuth = std::atan2(fixed.y, fixed.x);
    // On the unit sphere a highlight is wider in azimuth, the nearer it is to the normal.
    std::vector<double> phis = around(pi, std::min(1.0 / std::max(sine, 1e-3), 5.0));
    phis.insert(phis.end(), {pi / 2, 3 * pi / 2});
    const Tolerance tolerance{exact_to, of_itself * exact_to};
    const auto ring = [&](double t) {
        const auto at = [&](double phi) {
            return g(glm::dvec3(std::sin(t) * std::cos(azimuth + phi),
                                std::sin(t) * std::sin(azimuth + phi), std::cos(t)));
        };
        return adaptive(0, 2 * pi, phis, tolerance.shared(20), at) * std::cos(t) * std::sin(t);
    };
    return adaptive(0, pi / 2, around(theta, 1), tolerance, ring);
}

}  // namespace

double directional_albedo(const Reference& f, glm::dvec3 l, std::size_t channel, double tolerance)
{
    return over_hemisphere(l, tolerance, [&](glm::dvec3 v) { return f(l, v, channel); });
}

double hemispherical_directional(const Reference& f, glm::dvec3 v, std::size_t channel,
                                 double tolerance)
{
    return over_hemisphere(v, tolerance, [&](glm::dvec3 l) { return f(l, v, channel); });
}

}  // namespace gonio::reference
