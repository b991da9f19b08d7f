// SPDX-License-Identifier: Apache-2.0
// Bad parameters are refused with the allowed range, and at the ends of the ranges every model
// gives its documented limit, never NaN.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "gonio/errors.hpp"
#include "gonio/grid.hpp"
#include "gonio/material.hpp"
#include "verify/cases.hpp"

namespace gonio {
namespace {

using std::numbers::pi;
using testing::HasSubstr;

constexpr double infinity = std::numeric_limits<double>::infinity();

std::string refusal_of(Lobe& lobe, const Parameter& parameter, double number)
{
    const auto before = lobe.values;
    try {
        lobe.set(parameter.name, std::vector{number});
    } catch (const UsageError& error) {
        EXPECT_EQ(lobe.values, before) << "half set";
        return error.what();
    }
    return {};
}

TEST(ParameterLimits, TheNextNumberOutsideIsRefusedWithTheRange)
{
    for (const Model& model : models())
        for (const Parameter& parameter : model.parameters) {
            if (!parameter.is_number()) continue;
            SCOPED_TRACE(fmt::format("{} {}", model.id, parameter.name));
            Lobe lobe = default_lobe(model.id);
            for (const double end : {parameter.least, parameter.greatest})
                EXPECT_EQ(refusal_of(lobe, parameter, end), "");
            for (const double number : {std::nextafter(parameter.least, -infinity),
                                        std::nextafter(parameter.greatest, infinity), -infinity,
                                        infinity, std::numeric_limits<double>::quiet_NaN()}) {
                const std::string message = refusal_of(lobe, parameter, number);
                EXPECT_THAT(message, HasSubstr(fmt::format("`{}`", parameter.name)));
                EXPECT_THAT(message, HasSubstr(fmt::format("allowed is {} to {}", parameter.least,
                                                           parameter.greatest)));
                const std::string unit(parameter.unit == "1" ? "" : parameter.unit);
                EXPECT_THAT(message, HasSubstr(unit));
            }
        }
}

TEST(ParameterLimits, EveryNumberOfAColourIsLookedAt)
{
    Lobe lobe = default_lobe("lambert");
    EXPECT_THROW(lobe.set("rho", std::vector{0.5, 0.5, 1.5}), UsageError);
    EXPECT_THROW(lobe.set("rho", std::vector{0.1, 0.2, 0.3, 0.4, 0.5}), UsageError);
    EXPECT_THROW(lobe.set("rho", std::vector<double>{}), UsageError);
    EXPECT_THROW(lobe.set("weight", std::vector{-1e-9}), UsageError);
    Lobe phong = default_lobe("phong");
    EXPECT_THROW(phong.set("exponent", std::vector{1.0, 2.0}), UsageError);
}

/// Every combination of both ends of all parameters.
std::vector<Lobe> at_ends(const Lobe& form)
{
    std::vector<std::size_t> numbers;
    for (std::size_t k = 0; k < form.values.size(); ++k)
        if (form.model->parameters[k].is_number()) numbers.push_back(k);
    std::vector<Lobe> all;
    for (std::size_t mask = 0; mask < std::size_t{1} << numbers.size(); ++mask) {
        all.push_back(form);
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            const Parameter& parameter = form.model->parameters[numbers[k]];
            const bool upper = (mask >> k & 1) != 0;
            all.back().values[numbers[k]] = {upper ? parameter.greatest : parameter.least};
        }
    }
    return all;
}

/// Where something divides by 0 if it does anywhere: h = n, l = v, cos 0, the horizon.
std::vector<DirectionPair> corners()
{
    std::vector<DirectionPair> pairs;
    for (const double theta_i : {0.0, 1e-9, 45.0, 89.999, 90.0})
        for (const double theta_o : {0.0, 45.0, 90.0})
            for (const double phi : {0.0, 90.0, 180.0}) {
                pairs.push_back({theta_i, 0, theta_o, phi});
                pairs.push_back({theta_i, 90, theta_i, 90 + phi});
            }
    return pairs;
}

TEST(ParameterLimits, NoCornerOfTheParametersGivesNaN)
{
    const auto pairs = corners();
    for (const Model& model : models())
        for (const Lobe& form : single_variants(model))
            for (const Lobe& lobe : at_ends(form)) {
                const Reference f = make_reference({"", {lobe}}, Measure::brdf);
                for (const DirectionPair& pair : pairs) {
                    const auto [l, v] = unit_vectors(pair);
                    const double value = f(l, v, 0);
                    ASSERT_TRUE(std::isfinite(value) && value >= 0)
                        << value << " of " << model.id << " at " << pair.theta_i << ' '
                        << pair.phi_i << ' ' << pair.theta_o << ' ' << pair.phi_o;
                }
            }
}

double value_of(const std::string& model,
                const std::vector<std::pair<std::string, double>>& parameters, DirectionPair pair)
{
    Lobe lobe = default_lobe(model);
    for (const auto& [name, number] : parameters) lobe.set(name, std::vector{number});
    const auto [l, v] = unit_vectors(pair);
    return make_reference({"", {lobe}}, Measure::as_printed, Parameters::as_given)(l, v, 0);
}

TEST(ParameterLimits, AnExponentOf0IsConstantUpTo90Degrees)
{
    const DirectionPair inside{60, 0, 20, 90}, outside{60, 0, 60, 0};
    EXPECT_NEAR(value_of("phong", {{"rho_s", 1}, {"exponent", 0}}, inside), 1 / pi, 1e-15);
    EXPECT_EQ(value_of("phong", {{"rho_s", 1}, {"exponent", 0}}, outside), 0);
    EXPECT_NEAR(value_of("blinn_phong", {{"rho_s", 1}, {"exponent", 0}}, inside), 1 / pi, 1e-15);
    EXPECT_EQ(value_of("schlick", {{"k_s", 1}, {"exponent", 0}}, inside), 1);
    EXPECT_EQ(value_of("schlick", {{"k_s", 1}, {"exponent", 0}}, outside), 0);
    EXPECT_EQ(value_of("lafortune", {{"exponent", 0}}, inside), 1);
    EXPECT_EQ(value_of("lafortune", {{"exponent", 0}}, outside), 0);
}

TEST(ParameterLimits, ASmoothSurfaceScattersNothing)
{
    for (const char* model :
         {"beckmann_kirchhoff", "vernold_harvey", "he_torrance", "harvey_shack"})
        for (const DirectionPair& pair : corners())
            EXPECT_EQ(value_of(model, {{"sigma", 0}}, pair), 0) << model;
}

TEST(ParameterLimits, LambertIsTheLimitOfDiffuseModels)
{
    for (const DirectionPair& pair : corners()) {
        EXPECT_NEAR(value_of("oren_nayar", {{"rho", 1}, {"sigma", 0}}, pair), 1 / pi, 1e-15);
        EXPECT_NEAR(value_of("minnaert", {{"rho", 1}, {"k", 1}}, pair), 1 / pi, 1e-15);
    }
}

}  // namespace
}  // namespace gonio
