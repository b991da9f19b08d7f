// SPDX-License-Identifier: Apache-2.0
// Quadrature over the hemisphere in polar angles around the mirror direction.
#include "output/albedo_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <thread>

#include "reference/gauss_legendre.hpp"

namespace gonio {
namespace {

constexpr int nodes = 64;
constexpr double crowding = 5;  // a lobe of width w is seen where t^crowding = w
constexpr int greatest_angle = 89, angle_step = 3;

struct Node {
    double at, weight;
};

/// Nodes over [peak, end], crowded at the peak: at = peak + (end - peak) t^crowding.
std::vector<Node> crowded(double peak, double end)
{
    static const reference::QuadratureRule rule = reference::gauss_legendre(nodes);
    std::vector<Node> all;
    for (Eigen::Index k = 0; k < rule.nodes.size(); ++k) {
        const double t = rule.nodes[k];
        all.push_back(
            {peak + (end - peak) * std::pow(t, crowding),
             rule.weights[k] * std::abs(end - peak) * crowding * std::pow(t, crowding - 1)});
    }
    return all;
}

std::vector<double> albedo_at(const Reference& f, std::size_t channels, double theta_i)
{
    constexpr double pi = std::numbers::pi;
    const glm::dvec3 l(std::sin(theta_i), 0, std::cos(theta_i));
    std::vector<double> sums(channels, 0.0);
    // Angles from the mirror azimuth; the other half is the same.
    const std::vector<Node> azimuths = crowded(0, pi);
    for (const double end : {0.0, pi / 2}) {
        for (const Node& polar : crowded(theta_i, end)) {
            const double sine = std::sin(polar.at), cosine = std::cos(polar.at);
            for (const Node& azimuth : azimuths) {
                const glm::dvec3 v(-sine * std::cos(azimuth.at), sine * std::sin(azimuth.at),
                                   cosine);
                const double weight = 2 * polar.weight * azimuth.weight * sine * cosine;
                for (std::size_t c = 0; c < channels; ++c) sums[c] += weight * f(l, v, c);
            }
        }
    }
    return sums;
}

}  // namespace

std::vector<AlbedoPoint> albedo_curve(const Material& material)
{
    const Reference f = make_reference(material, Measure::brdf);
    const std::size_t channels = material.channels();
    std::vector<AlbedoPoint> points;
    for (int theta = 0; theta < greatest_angle; theta += angle_step)
        points.push_back({1.0 * theta, {}});
    points.push_back({greatest_angle, {}});
    const std::size_t workers = std::max(1U, std::thread::hardware_concurrency());
    std::vector<std::jthread> threads;
    for (std::size_t w = 0; w < workers; ++w)
        threads.emplace_back([&, w] {
            for (std::size_t k = w; k < points.size(); k += workers)
                points[k].albedo =
                    albedo_at(f, channels, points[k].theta_i * std::numbers::pi / 180);
        });
    threads.clear();
    return points;
}

}  // namespace gonio
