// SPDX-License-Identifier: Apache-2.0
// Layered media that no light could travel through are refused with the place, the value and the
// range.
#include "gonio/layers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "gonio/errors.hpp"

namespace gonio {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The message of the refusal; empty where the medium is accepted.
std::string refusal(const LayeredMedium& medium)
{
    try {
        validate(medium);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "";
}

LayeredMedium slab()
{
    LayeredMedium medium;
    medium.layers = {{.mua = 1, .mus = 10, .n = 1.4, .d = 0.1, .phase = HenyeyGreenstein{0.8}},
                     {.mua = 1, .mus = 10, .n = 1.4, .phase = HenyeyGreenstein{0.8}}};
    return medium;
}

template <class Change>
std::string refusal_after(Change change)
{
    LayeredMedium medium = slab();
    change(medium);
    return refusal(medium);
}

std::string refusal_of(const PhaseFunction& phase)
{
    return refusal_after([&](LayeredMedium& medium) { medium.layers[1].phase = phase; });
}

TEST(LayersTest, AcceptsWhatLightCanTravelThrough)
{
    EXPECT_EQ(refusal(slab()), "");
    EXPECT_EQ(refusal_after([](auto& medium) { medium.layers[0].mua = medium.layers[0].mus = 0; }),
              "");
    EXPECT_EQ(refusal_after([](auto& medium) { medium.layers[1].mua = 0; }), "");
    EXPECT_EQ(refusal_after(
                  [](auto& medium) { medium.layers.pop_back(), medium.bottom = Bottom::mirror; }),
              "");
}

TEST(LayersTest, NamesTheLayerTheValueAndTheRange)
{
    using Medium = LayeredMedium;
    EXPECT_EQ(refusal_after([](Medium& m) { m.layers[0].mua = -1; }),
              "layer 1: mua = -1 must be finite and at least 0 1/cm");
    EXPECT_EQ(refusal_after([](Medium& m) { m.layers[0].mua = nan; }),
              "layer 1: mua = nan must be finite and at least 0 1/cm");
    EXPECT_EQ(refusal_after([](Medium& m) { m.layers[1].mus = infinity; }),
              "layer 2: mus = inf must be finite and at least 0 1/cm");
    EXPECT_EQ(refusal_after([](Medium& m) { m.layers[1].n = 0; }),
              "layer 2: n = 0 must be finite and above 0");
    EXPECT_EQ(refusal_after([](Medium& m) { m.layers[0].d = 0; }),
              "layer 1: d = 0 must be above 0 cm");
    EXPECT_EQ(refusal_after([](Medium& m) { m.layers[0].d = nan; }),
              "layer 1: d = nan must be above 0 cm");
    EXPECT_EQ(refusal_after([](Medium& m) { m.n_above = -1; }),
              "n_above = -1 must be finite and above 0");
    EXPECT_EQ(refusal_after([](Medium& m) { m.n_below = nan; }),
              "n_below = nan must be finite and above 0");
    EXPECT_EQ(refusal_after([](Medium& m) { m.bottom_albedo = 1.5; }),
              "bottom_albedo = 1.5 must be in [0, 1]");
}

TEST(LayersTest, RefusesWhatCannotBeStacked)
{
    using Medium = LayeredMedium;
    EXPECT_EQ(refusal({}), "a layered medium needs at least one layer");
    EXPECT_EQ(refusal_after([](Medium& m) { m.layers[0].d = infinity; }),
              "layer 1: only the last layer may be infinite");
    EXPECT_EQ(refusal_after([](Medium& m) { m.layers[1].mua = m.layers[1].mus = 0; }),
              "layer 2: an infinite layer must absorb or scatter: mua + mus = 0");
    EXPECT_EQ(
        refusal_after([](Medium& m) { m.bottom = Bottom::black; }),
        "the last layer is infinite, so that no light reaches the bottom; the bottom must be open");
}

TEST(LayersTest, RefusesPhaseFunctionsOutOfRange)
{
    EXPECT_EQ(refusal_of(HenyeyGreenstein{1}), "layer 2: g = 1 must be in (-1, 1)");
    EXPECT_EQ(refusal_of(HenyeyGreenstein{-1}), "layer 2: g = -1 must be in (-1, 1)");
    EXPECT_EQ(refusal_of(HenyeyGreenstein{nan}), "layer 2: g = nan must be in (-1, 1)");
    EXPECT_EQ(refusal_of(TwoTermHenyeyGreenstein{0.9, -2, 0.5}),
              "layer 2: g_2 = -2 must be in (-1, 1)");
    EXPECT_EQ(refusal_of(TwoTermHenyeyGreenstein{0.9, -0.2, 1.5}),
              "layer 2: weight_1 = 1.5 must be in [0, 1]");
    EXPECT_EQ(refusal_of(TabulatedPhase{{-1, 1}, {1}}),
              "layer 2: a tabulated phase function has 2 cosines and 1 values; it needs as many of "
              "both, and "
              "at least 2");
    EXPECT_EQ(refusal_of(TabulatedPhase{{-0.5, 1}, {1, 1}}),
              "layer 2: the first cosine = -0.5 must be -1");
    EXPECT_EQ(refusal_of(TabulatedPhase{{-1, 0.5}, {1, 1}}),
              "layer 2: the last cosine = 0.5 must be 1");
    EXPECT_EQ(refusal_of(TabulatedPhase{{-1, 0.5, 0.5, 1}, {1, 1, 1, 1}}),
              "layer 2: cosine 3 = 0.5 must be above the one before it");
    EXPECT_EQ(refusal_of(TabulatedPhase{{-1, 1}, {1, -1}}),
              "layer 2: phase function value 2 = -1 must be finite and at least 0");
    EXPECT_EQ(refusal_of(TabulatedPhase{{-1, 1}, {0, 0}}),
              "layer 2: a tabulated phase function must be above 0 somewhere");
}

}  // namespace
}  // namespace gonio
