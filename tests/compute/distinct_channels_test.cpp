// SPDX-License-Identifier: Apache-2.0
// Channels that agree, lobes that reflect nothing and facets that reflect all are left out, and no
// bit changes.
#include "compute/distinct_channels.hpp"

#include <gtest/gtest.h>

#include <random>

#include "compute/idle_lobes.hpp"
#include "compute/shared_device.hpp"
#include "gonio/compute.hpp"

namespace gonio {
namespace {

using Numbers = std::vector<double>;

class LeftOut : public test::SharedDevice {};

Lobe lobe(std::string_view model,
          const std::vector<std::pair<std::string_view, Numbers>>& parameters = {})
{
    Lobe made = default_lobe(model);
    for (const auto& [name, numbers] : parameters) made.set(name, numbers);
    return made;
}

Lobe facets(std::string_view fresnel, const Numbers& eta, const Numbers& k = {0})
{
    Lobe made = lobe("ggx", {{"eta", eta}, {"k", k}});
    made.set("fresnel", fresnel);
    return made;
}

TEST(DistinctChannels, AreThoseWhoseNumbersDiffer)
{
    const Material material{
        "m", {lobe("lambert", {{"rho", {0.2, 0.4, 0.2, 0.2}}}), facets("dielectric", {1.5})}};
    const DistinctChannels distinct = distinct_channels(material);
    EXPECT_EQ(distinct.of, (std::vector<std::size_t>{0, 1, 0, 0}));
    EXPECT_EQ(distinct.material.channels(), 2U);
    Material weighted = material;
    weighted.lobes[1].weight = {1, 1, 0.5, 1};
    EXPECT_EQ(distinct_channels(weighted).of, (std::vector<std::size_t>{0, 1, 2, 0}));
    const DistinctChannels grey =
        distinct_channels({"m", {lobe("phong", {{"rho_s", {0.3, 0.3, 0.3}}})}});
    EXPECT_EQ(grey.of, (std::vector<std::size_t>{0, 0, 0}));
    EXPECT_EQ(grey.material.channels(), 1U);
}

TEST(IdleLobes, AreThoseWithoutWeightOrReflectance)
{
    EXPECT_TRUE(is_idle(lobe("ggx", {{"weight", {0, 0}}})));
    EXPECT_TRUE(is_idle(lobe("lambert", {{"rho", {0}}})));
    EXPECT_FALSE(is_idle(lobe("lambert", {{"rho", {0, 0.1}}})));
    EXPECT_FALSE(is_idle(lobe("ggx", {{"f0", {0}}})));  // Schlick's reflectance rises to grazing
    EXPECT_TRUE(is_idle(facets("dielectric", {1, 1})));
    EXPECT_FALSE(is_idle(facets("dielectric", {1, 1.1})));
    EXPECT_TRUE(is_idle(facets("conductor", {1})));
    EXPECT_FALSE(is_idle(facets("conductor", {1}, {0.1})));
    EXPECT_EQ(even_facet_reflectance(lobe("ggx", {{"f0", {1}}})), 1);
    EXPECT_FALSE(even_facet_reflectance(lobe("ggx", {{"f0", {1, 0.9}}})));
    EXPECT_FALSE(even_facet_reflectance(lobe("lambert")));
}

TEST(IdleLobes, ReflectNothingInAnyModelThatSaysSo)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> even(0, 1);
    std::size_t found = 0;
    for (const Model& model : models())
        for (const ParameterAt& at : model.dark_at) {
            Lobe dark = default_lobe(model.id);
            dark.set(at.name, Numbers{at.number});
            const Reference f = make_reference({"m", {dark}}, Measure::brdf);
            for (int k = 0; k < 100; ++k) {
                const auto [l, v] = unit_vectors(
                    {89 * even(random), 360 * even(random), 89 * even(random), 360 * even(random)});
                EXPECT_EQ(f(l, v, 0), 0) << model.id;
            }
            ++found;
        }
    EXPECT_EQ(found, 10U);
}

TEST(IdleLobes, GoWithoutTheirChannels)
{
    const Material coloured{
        "m", {lobe("phong"), lobe("ward", {{"rho_s", {0.1, 0.2, 0.3}}, {"weight", {0}}})}};
    const Material rest = without_idle_lobes(coloured);
    ASSERT_EQ(rest.lobes.size(), 1U);
    EXPECT_EQ(rest.lobes[0].model->id, "phong");
    EXPECT_EQ(rest.channels(), 3U);
    EXPECT_EQ(distinct_channels(rest).material.channels(), 1U);
}

TEST(IdleLobes, LeaveALambertianSurfaceWithoutWeight)
{
    const Lobe clear = facets("dielectric", {1, 1, 1}),
               unweighted = lobe("beckmann_kirchhoff", {{"weight", {0, 0, 0}}});
    for (const std::vector<Lobe>& idle : {std::vector{clear}, {unweighted}, {unweighted, clear}}) {
        const Material rest = without_idle_lobes({"m", idle});
        ASSERT_EQ(rest.lobes.size(), 1U);
        EXPECT_EQ(rest.lobes[0].model->id, "lambert");
        EXPECT_EQ(rest.channels(), 3U);
        EXPECT_TRUE(is_idle(rest.lobes[0]));
    }
}

/// Materials whose colours, or facets, ask for different programs; or of which nothing is left.
Material coloured(int pattern, std::mt19937& random)
{
    const auto number = [&] { return std::uniform_real_distribution<double>(0.05, 0.95)(random); };
    const double a = number(), b = number(), c = number(), eta = 1.1 + number();
    Lobe smooth = facets("dielectric", {eta});
    smooth.set("alpha", Numbers{number()});
    Material material{"m", {lobe("lambert", {{"rho", {a, b, c}}}), smooth}};
    if (pattern == 4)
        return {"m", {facets("dielectric", {1}), lobe("ward", {{"weight", {0, 0, 0}}})}};
    if (pattern == 1) material.lobes[0].set("rho", Numbers{a, a, a});
    if (pattern == 2) material.lobes[0].set("rho", Numbers{a, b, a});
    if (pattern < 3) return material;
    material.lobes[1].set("fresnel", "schlick");  // f0 is 1
    material.lobes.push_back(facets("dielectric", {1, 1, 1}));
    material.lobes.push_back(lobe("phong", {{"rho_s", {0}}}));
    return material;
}

TEST_F(LeftOut, ChannelsAndFacetsChangeNoBitOfEightyTables)
{
    const auto values = [&](const Material& material, const Grid& grid, bool leave_out) {
        std::vector<std::vector<float>> channels(3);
        const auto sink = [&](const Rows<float>& rows) {
            ASSERT_EQ(rows.planes.size(), 3U);
            for (std::size_t c = 0; c < 3; ++c)
                channels[c].insert(channels[c].end(), rows.planes[c],
                                   rows.planes[c] + rows.count * grid.axes.back().values.size());
        };
        compute_grid(*device(), material, Measure::brdf, grid, sink, {.leave_out = leave_out});
        return channels;
    };
    std::mt19937 random(1);
    for (int table = 0; table < 80; ++table) {
        const Material material = coloured(table % 5, random);
        const std::size_t size = 2 + random() % 4;
        const Grid grid = isotropic_grid(size, size + random() % 2, 32 + random() % 40,
                                         table % 2 == 0 ? Samples::centre : Samples::node, 360);
        EXPECT_EQ(values(material, grid, true), values(material, grid, false)) << table;
    }
}

}  // namespace
}  // namespace gonio
