// SPDX-License-Identifier: Apache-2.0
// The definition of a table: the same for the same request, however it is written.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "gonio/job.hpp"

namespace gonio {
namespace {

/// A scene of one table in which tests replace parts.
const std::string base = R"([output]
format = "exr"
[[material]]
name = "steel"
model = "ggx"
weight = 1
[material.parameters]
alpha = 0.1
fresnel = "schlick"
f0 = [0.5, 0.5, 0.5]
[[table]]
material = "steel"
quantity = "brdf"
grid = { kind = "isotropic", theta_i = 4, theta_o = 3, delta_phi = 2 }
)";

std::string with(const std::string& part, const std::string& instead)
{
    std::string text = base;
    const auto at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    return text.replace(at, part.size(), instead);
}

std::string definition_of(const std::string& text, const std::string& file = "scene.toml")
{
    return definition(plan_jobs(parse_scene(text, file)).front());
}

TEST(Definition, IsTheSameForTheSameRequest)
{
    const auto expected = definition_of(base);
    EXPECT_EQ(definition_of(base, "other.toml"), expected);
    EXPECT_EQ(definition_of("# a comment\n\n" + base), expected);
    EXPECT_EQ(definition_of(with("model = \"ggx\"", "model = \"torrance_sparrow\"")), expected);
    EXPECT_EQ(definition_of(with("alpha = 0.1", "alpha_y = 0.1\nalpha_x = 1e-1")), expected);
    EXPECT_EQ(definition_of(with("fresnel = \"schlick\"\n", "")), expected);
    EXPECT_EQ(definition_of(with("weight = 1", "weight = 1.0")), expected);
    EXPECT_EQ(definition_of(with("weight = 1\n", "")), expected);
    EXPECT_EQ(definition_of(with("format = \"exr\"", "directory = \"elsewhere\"")), expected);
    EXPECT_EQ(
        definition_of(with("format = \"exr\"", "compression = \"zip\"\nprecision = \"float\"")),
        expected);
    EXPECT_EQ(definition_of(with("delta_phi = 2", "delta_phi = 2.0, samples = \"centre\"")),
              expected);
    EXPECT_EQ(definition_of(with("delta_phi = 2", "delta_phi = 2, delta_phi_to = 360")), expected);
    EXPECT_EQ(definition_of(with("quantity", "solver = \"closed_form\"\nquantity")), expected);
}

TEST(Definition, IsAnotherForEveryOtherRequest)
{
    const std::string grid = "kind = \"isotropic\", theta_i = 4, theta_o = 3, delta_phi = 2";
    const std::string other = "kind = \"rusinkiewicz\", theta_h = 4, theta_d = 3, phi_d = 2";
    const std::vector<std::string> requests = {
        base,
        with("model = \"ggx\"", "model = \"beckmann\""),
        with("alpha = 0.1", "alpha = 0.10000000000000001e1"),
        with("alpha = 0.1", "alpha = { values = [0.1] }"),
        with("alpha = 0.1", "alpha = { values = [0.1, 0.2] }"),
        with("alpha = 0.1", "alpha = { values = [0.2, 0.1] }"),
        with("fresnel = \"schlick\"", "fresnel = \"dielectric\""),
        with("f0 = [0.5, 0.5, 0.5]", "f0 = 0.5"),
        with("f0 = [0.5, 0.5, 0.5]", "f0 = [0.5, 0.5, 0.6]"),
        with("f0 = [0.5, 0.5, 0.5]", "f0 = [0.5, 0.5, 0.5]\neta = 1.4"),
        with("weight = 1", "weight = 2"),
        with("weight = 1", "weight = [1, 1, 2]"),
        with("\"brdf\"", "\"brdf_cosine\""),
        with("theta_i = 4", "theta_i = 5"),
        with("delta_phi = 2", "delta_phi = 2, delta_phi_to = 180"),
        with("delta_phi = 2", "delta_phi = 2, samples = \"node\""),
        with(grid, other),
        with(grid, other + ", spacing = \"merl\""),
        with(grid, "kind = \"anisotropic\", theta_i = 4, phi_i = 1, theta_o = 3, phi_o = 2"),
        with("format = \"exr\"", "format = \"npy\""),
        with("format = \"exr\"", "format = \"csv\""),
        with("format = \"exr\"", "precision = \"half\""),
        with("format = \"exr\"", "compression = \"piz\""),
    };
    std::map<std::string, std::string> seen;
    for (const auto& request : requests) {
        const auto [earlier, is_new] = seen.emplace(definition_of(request), request);
        EXPECT_TRUE(is_new) << request << "\nhas the definition of\n" << earlier->second;
    }
}

}  // namespace
}  // namespace gonio
