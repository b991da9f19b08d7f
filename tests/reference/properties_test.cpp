// SPDX-License-Identifier: Apache-2.0
// What every reference of the registry must be, whatever its options and parameters: finite, not
// negative, reciprocal and isotropic where its block says so, and not where it does not.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "gonio/errors.hpp"
#include "reference/reference_fixtures.hpp"
#include "verify/cases.hpp"

namespace gonio {
namespace {

using std::numbers::pi;

std::string describe(const Lobe& lobe)
{
    std::string text(lobe.model->id);
    for (std::size_t k = 0; k < lobe.values.size(); ++k) {
        const Parameter& parameter = lobe.model->parameters[k];
        const double value = lobe.values[k][0];
        text += parameter.kind == Kind::choice
                    ? fmt::format(" {}={}", parameter.name,
                                  parameter.options[static_cast<std::size_t>(value)].name)
                    : fmt::format(" {}={}", parameter.name, value);
    }
    return text;
}

/// At an end of its range, or in it: evenly in the logarithm where 0 is not in the range.
double any_value(const Parameter& parameter, std::mt19937& random)
{
    const double u = std::uniform_real_distribution<double>(0, 1)(random);
    if (u < 0.2) return parameter.least;
    if (u > 0.8) return parameter.greatest;
    const double part = (u - 0.2) / 0.6;
    if (parameter.least > 0)
        return parameter.least * std::pow(parameter.greatest / parameter.least, part);
    return parameter.least + (parameter.greatest - parameter.least) * std::pow(part, 3);
}

Lobe with_any_parameters(Lobe lobe, std::mt19937& random)
{
    for (const Parameter& parameter : lobe.model->parameters)
        if (parameter.is_number()) lobe.set(parameter.name, {any_value(parameter, random)});
    return lobe;
}

/// Normal incidence, grazing, the mirror and its neighbours, retro-reflection, and any pair.
std::vector<Geometry> extreme_geometries()
{
    std::vector<Geometry> all;
    for (const double cos_i : {1.0, 1 - 1e-12, 0.7, 0.1, 1e-3, 1e-7}) {
        const glm::dvec3 l = direction_of_cosine(cos_i, 0.5);
        all.push_back({l, {-l.x, -l.y, l.z}});
        all.push_back({l, l});
        all.push_back({l, direction_of_cosine(cos_i, 0.5 + pi)});
        for (const double cos_o : {1.0, 0.7, 0.1, 1e-7})
            for (const double phi : {0.5, 0.5 + 1e-8, 0.5 + pi / 2, 0.5 + pi, 2.0})
                all.push_back({l, direction_of_cosine(cos_o, phi)});
    }
    return all;
}

Brdf brdf_of(const Lobe& lobe)
{
    const Reference f = make_reference({"", {lobe}}, Measure::brdf);
    return [f](glm::dvec3 l, glm::dvec3 v) { return f(l, v, 0); };
}

TEST(ReferencePropertyTest, FiniteAndNotNegativeEverywhere)
{
    std::mt19937 random(1);
    const std::vector<Geometry> geometries = extreme_geometries();
    for (const Model& model : models())
        for (const Lobe& form : all_variants(model))
            for (int k = 0; k < 12; ++k) {
                const Lobe lobe = with_any_parameters(form, random);
                const Brdf f = brdf_of(lobe);
                for (const auto& [l, v] : geometries) {
                    const double value = f(l, v);
                    ASSERT_TRUE(std::isfinite(value) && value >= 0)
                        << value << " of " << describe(lobe)
                        << fmt::format(" at l = ({}, {}, {}), v = ({}, {}, {})", l.x, l.y, l.z, v.x,
                                       v.y, v.z);
                }
            }
}

double greatest_asymmetry(const Lobe& lobe)
{
    const Brdf f = brdf_of(lobe);
    double greatest = 0;
    for (const auto& [l, v] : extreme_geometries()) {
        const double there = f(l, v), back = f(v, l);
        greatest = std::max(greatest, std::abs(there - back) / (there + back + 1e-290));
    }
    return greatest;
}

TEST(ReferencePropertyTest, ReciprocalUnlessTheBlockSaysNot)
{
    std::mt19937 random(2);
    for (const Model& model : models())
        for (const Lobe& form : all_variants(model)) {
            if ((form.traits() & ONE_WAY) != 0) {
                EXPECT_GT(greatest_asymmetry(form), 0.1) << describe(form);
                continue;
            }
            for (int k = 0; k < 6; ++k) {
                const Lobe lobe = with_any_parameters(form, random);
                EXPECT_LT(greatest_asymmetry(lobe), 1e-12) << describe(lobe);
            }
        }
}

/// The greatest relative change when light and viewer turn around the normal together.
double greatest_change_by_rotation(const Lobe& lobe)
{
    const Brdf f = brdf_of(lobe);
    double greatest = 0;
    for (const double cos_i : {0.9, 0.5, 0.2})
        for (const double cos_o : {0.8, 0.4})
            for (const double phi : {0.4, 2.8}) {
                const auto turned = [&](double angle) {
                    return f(direction_of_cosine(cos_i, angle),
                             direction_of_cosine(cos_o, angle + phi));
                };
                const double before = turned(0), after = turned(1);
                greatest = std::max(greatest, std::abs(before - after) / (before + after + 1e-290));
            }
    return greatest;
}

TEST(ReferencePropertyTest, IsotropicWhereTheLobeSaysSo)
{
    for (const Model& model : models())
        for (const Lobe& form : all_variants(model)) {
            ASSERT_TRUE(form.isotropic()) << describe(form);
            EXPECT_LT(greatest_change_by_rotation(form), 1e-11) << describe(form);
            std::vector<std::string_view> splitting;
            for (const Both& both : model.both) splitting.push_back(both.first);
            for (const ParameterAt& at : model.isotropic_at) splitting.push_back(at.name);
            for (const std::string_view name : splitting) {
                Lobe brushed = form;
                brushed.set(name, {form.values[model.index_of(name)][0] * 0.5});
                EXPECT_FALSE(brushed.isotropic()) << describe(brushed);
                EXPECT_GT(greatest_change_by_rotation(brushed), 1e-3) << describe(brushed);
            }
        }
}

// Where a family has no limit, its parameter is refused; where it has one, the limit is taken.
TEST(ReferencePropertyTest, DegenerateParameters)
{
    for (const char* text :
         {"ward alpha=0", "ggx alpha_y=0", "cook_torrance m=0", "torrance_sparrow_1967 width=0",
          "schlick_1994 roughness=0", "schlick_1994 isotropy=0", "charlie roughness=0",
          "he_torrance tau=0", "beckmann_kirchhoff wavelength=0", "strauss smoothness=1"})
        EXPECT_THROW(lobe_of(text), UsageError) << text;
    const glm::dvec3 l = direction(30, 0), mirror = direction(30, 180), across = direction(60, 0);
    EXPECT_EQ(reference_of("phong form=phong_1975 exponent=0", Measure::as_printed)(l, mirror),
              0.5);
    EXPECT_EQ(reference_of("schlick exponent=0", Measure::as_printed)(l, mirror), 0.5);
    EXPECT_EQ(reference_of("phong exponent=0")(l, direction(61, 0)), 0) << "beyond 90 degrees";
    EXPECT_EQ(reference_of("lafortune exponent=0 c_xy=1 c_z=-1")(l, mirror), 0) << "no lobe there";
    EXPECT_EQ(reference_of("he_torrance sigma=0")(l, across), 0);
    EXPECT_EQ(reference_of("charlie")({0, 0, 1}, {0, 0, 1}), 0) << "h = n";
}

}  // namespace
}  // namespace gonio
