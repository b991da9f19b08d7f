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
        std::vector<double> expected(pairs().size());
        for (const Lobe& lobe : sum.lobes) {
            const std::vector<float> alone = values(device, {"alone", {lobe}});
            for (std::size_t k = 0; k < alone.size(); ++k)
                expected[k] += static_cast<double>(alone[k]);
        }
        const std::vector<float> together = values(device, sum);
        for (std::size_t k = 0; k < together.size(); ++k)
            EXPECT_NEAR(together[k], expected[k], 2e-6 * expected[k]) << sum.lobes.size();
    }
}

TEST(Lobes, OfEveryOptionHaveTheSameBitsAtEveryWidth)
{
    const Device narrow("", 1);
    for (const unsigned width : {2U, 4U, 8U, 16U}) {
        const Device wide("", width);
        for (const Material& sum : sums())
            EXPECT_EQ(values(narrow, sum), values(wide, sum)) << "width " << width;
    }
}

}  // namespace
}  // namespace gonio
