// SPDX-License-Identifier: Apache-2.0
// Photons in layers that are stiff: from clear to opaque, with and without absorption, all but
// forward scattering, at total reflection.
#include <cmath>
#include <numbers>

#include "photon/weight_sums.hpp"
#include "reference/adding_doubling.hpp"
#include "verify/extreme.hpp"

namespace gonio {
namespace {

constexpr std::uint64_t photons = 1 << 16, batch = 1 << 10;
constexpr double exact_to = 1e-4;  // far below what so few photons can tell
constexpr double significance = 0.01;

struct HardMedium {
    std::string name;
    LayeredMedium medium;
    double incidence = 0;  ///< degrees
};

Layer layer(double mua, double mus, double g, double n, double d)
{
    return {.mua = mua, .mus = mus, .n = n, .d = d, .phase = HenyeyGreenstein{g}};
}

std::vector<HardMedium> hard_media()
{
    LayeredMedium twenty;
    for (int k = 0; k < 20; ++k)
        twenty.layers.push_back(layer(k % 3, 20 + 10 * k, 0.9 - 0.09 * k, 1.3 + 0.02 * k, 0.01));
    return {
        {"g = 0.99", {.layers = {layer(1, 1000, 0.99, 1.4, 0.2)}}},
        {"g = -0.99", {.layers = {layer(1, 100, -0.99, 1.4, 0.1)}}},
        {"g = 1e-6", {.layers = {layer(1, 100, 1e-6, 1.4, 0.1)}}},
        {"albedo 1", {.layers = {layer(0, 100, 0.8, 1.4, 0.2)}}},
        {"albedo 1 - 1e-7", {.layers = {layer(1e-5, 100, 0.8, 1.4, 0.2)}}},
        {"optical depths 1e-6 over 1e6",
         {.layers = {layer(0.5, 0.5, 0.5, 1, 1e-6), layer(1e5, 9e5, 0.5, 1, 1)}}},
        {"n = 1, 1.5, 1, 2.5, 1",
         {.layers = {layer(1, 20, 0.5, 1.5, 0.05), layer(0, 0, 0, 1, 0.05),
                     layer(1, 20, 0.5, 2.5, 0.05)}}},
        {"light at 89.99 degrees", {.layers = {layer(1, 100, 0.8, 1.4, 0.1)}}, 89.99},
        {"20 layers", twenty},
    };
}

/// The z that a normal variable exceeds in size with the probability `tail`, by bisection of erfc.
double quantile(double tail)
{
    double low = 0, high = 10;
    for (int k = 0; k < 60; ++k) {
        const double middle = (low + high) / 2;
        (std::erfc(middle / std::numbers::sqrt2) > tail ? low : high) = middle;
    }
    return high;
}

}  // namespace

std::vector<MediumVerdict> verify_media(const Device& device)
{
    const std::vector<HardMedium> media = hard_media();
    const double each = -std::expm1(std::log1p(-significance) / static_cast<double>(media.size()));
    const double bound = quantile(each);
    std::vector<MediumVerdict> verdicts;
    for (const auto& [name, medium, incidence] : media) {
        const LightSource light{.incidence = incidence * std::numbers::pi / 180};
        PhotonTracer tracer(device, medium, {.light = light, .batch = batch});
        tracer.trace(photons, [](std::uint64_t) {});
        const Fraction found = tracer.result().diffuse_reflectance;
        const double exact =
            reference::solve_layers_to(medium, {.incidence = {light.incidence}}, exact_to)
                .collimated.front()
                .budget.diffuse_reflectance;
        const double spread = std::hypot(found.error, exact_to);
        verdicts.push_back(
            {name, exact, found.mean, found.error, std::abs(found.mean - exact) / spread, bound});
    }
    return verdicts;
}

SumVerdict verify_sum()
{
    constexpr std::uint64_t batches = 10'000, photons_of_batch = 1 << 20, unit = 1 << 30;
    WeightSums sums(1);
    for (std::uint64_t k = 0; k < batches; ++k)
        sums.add_batch({photons_of_batch * unit}, photons_of_batch);
    float naive = 0;
    while (naive + 1 > naive) ++naive;  // from here on nothing is added
    const double all = static_cast<double>(sums.photons());
    return {all, std::abs(sums.fraction(0).mean - 1), 1 - static_cast<double>(naive) / all};
}

}  // namespace gonio
