// SPDX-License-Identifier: Apache-2.0
// The whole catalogue in single programs: every option of every model beside others, at every
// width.
#include <gtest/gtest.h>

#include <cmath>

#include "gonio/compute.hpp"
#include "verify/cases.hpp"

namespace gonio {
namespace {

/// Sums that hold each model at most once and together every option; each lobe with a weight of its
/// own.
std::vector<Material> sums()
{
    std::vector<Material> all;
    for (const Model& model : models()) {
        const std::vector<Lobe> lobes = single_variants(model);
        all.resize(std::max(all.size(), lobes.size()));
        for (std::size_t k = 0; k < lobes.size(); ++k) {
            all[k].lobes.push_back(lobes[k]);
            all[k].lobes.back().weight = {0.5 + 0.125 * static_cast<double>(all[k].lobes.size())};
        }
    }
    return all;
}

/// Away from grazing, where one lobe's pole would hide the others.
std::vector<DirectionPair> pairs()
{
    std::vector<DirectionPair> all;
    for (int k = 0; k < 48; ++k)
        all.push_back({1.0 + 1.5 * k, 20, 70 - 1.4 * k, 200.0 + 3 * (k % 16)});
    return all;
}

std::vector<float> values(const Device& device, const Material& material)
{
    return compute_points(device, material, Measure::brdf, pairs())[0];
}

TEST(Lobes, OfTheWholeCatalogueAddUpInOneProgram)
{
    const Device device;
    for (const Material& sum : sums()) {
        const Reference reference = make_reference(sum, Measure::brdf);
        const std::vector<float> together = values(device, sum);
        for (std::size_t k = 0; k < together.size(); ++k) {
            const auto [l, v] = unit_vectors(pairs()[k]);
            const double expected = reference(l, v, 0);
            EXPECT_NEAR(together[k], expected, 1e-5 * expected) << sum.lobes.size();
        }
    }
}

TEST(Lobes, OfEveryOptionHaveTheSameBitsAtEveryWidth)
{
    // The first sum holds every model; it takes long to build.
    const Device narrow("", 1);
    const std::vector<Material> all = sums();
    for (const unsigned width : {2U, 4U, 8U, 16U})
        EXPECT_EQ(values(narrow, all[0]), values(Device("", width), all[0])) << "width " << width;
    for (std::size_t k = 1; k < all.size(); ++k) {
        const unsigned width = 2U << k % 4;
        EXPECT_EQ(values(narrow, all[k]), values(Device("", width), all[k])) << "width " << width;
    }
}

}  // namespace
}  // namespace gonio
