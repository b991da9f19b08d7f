// SPDX-License-Identifier: Apache-2.0
// Compares hard spots on a device, and in their textbook forms, with the reference.
#include "verify/extreme.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gonio/compute.hpp"

namespace gonio {
namespace {

constexpr double absolute_bound = 1e-9;  // where f is below 1e-6 of its maximum, of the maximum

/// As a program in float32 makes it from angles.
glm::vec3 vector_of(double theta_degrees, double phi_degrees)
{
    constexpr float radian = std::numbers::pi_v<float> / 180;
    const float theta = static_cast<float>(theta_degrees) * radian;
    const float phi = static_cast<float>(phi_degrees) * radian;
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

}  // namespace

bool SpotVerdict::passed() const
{
    return device.not_finite == 0 && device.relative <= bound && device.absolute <= absolute_bound;
}

SpotVerdict verify_spot(const Device& device, const HardSpot& spot)
{
    const Material material{spot.name, {spot.lobe}};
    const Reference reference = make_reference(material, Measure::as_printed);
    std::vector<double> expected;
    std::vector<float> textbook;
    for (const DirectionPair& pair : spot.pairs) {
        const auto [l, v] = unit_vectors(pair);
        expected.push_back(reference(l, v, 0));
        textbook.push_back(spot.textbook(spot.lobe, vector_of(pair.theta_i, pair.phi_i),
                                         vector_of(pair.theta_o, pair.phi_o)));
    }
    const auto in_double = [&](std::size_t k) {
        const auto [l, v] = unit_vectors(spot.pairs[k]);
        return sensitivity(reference, l, v, 0, direction_rounding(material));
    };
    SpotVerdict verdict{
        .name = spot.name,
        .device = compare(compute_points(device, material, Measure::as_printed, spot.pairs)[0],
                          expected, in_double),
        .textbook = compare(textbook, expected, [](std::size_t) { return 0.0; }),
        .bound = accuracy_bound(material)};
    constexpr double nudge = 1e-9;
    for (std::size_t k = 0; k < expected.size(); ++k) {
        if (!(std::abs(expected[k]) > 1e-6 * verdict.device.maximum)) continue;
        const auto [l, v] = unit_vectors(spot.pairs[k]);
        verdict.condition = std::max(verdict.condition,
                                     sensitivity(reference, l, v, 0, nudge) / expected[k] / nudge);
    }
    return verdict;
}

}  // namespace gonio
