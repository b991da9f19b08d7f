// SPDX-License-Identifier: Apache-2.0
// Sizes, attributes and soundness of headers.
#include "gonio/table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "gonio/errors.hpp"
#include "output/check.hpp"
#include "output/table_fixtures.hpp"

namespace gonio {
namespace {

using testing::HasSubstr;

TEST(TableHeader, CountsRowsAndCells)
{
    const auto header = test::swept_header();
    EXPECT_EQ(header.row_length(), 7u);
    EXPECT_EQ(header.rows(), 2u * 5 * 3);
    EXPECT_EQ(header.cells(), 2u * 5 * 3 * 7);
    EXPECT_EQ(TableHeader().cells(), 1u);
}

TEST(TableHeader, FindsAttributes)
{
    const auto header = test::small_header();
    ASSERT_NE(header.find("alpha"), nullptr);
    EXPECT_EQ(std::get<double>(*header.find("alpha")), 0.1);
    EXPECT_EQ(header.find("beta"), nullptr);
}

TEST(TableHeader, SaysHowBigItWouldBe)
{
    auto header = test::small_header();
    Axis axis{"a", "1", {}, Samples::node};
    for (int k = 0; k < 100'000; ++k) axis.values.push_back(k);
    for (const auto* name : {"a", "b", "c", "d"}) {
        header.axes.push_back(axis);
        header.axes.back().name = name;
    }
    try {
        header.cells();
        ADD_FAILURE() << "counted";
    } catch (const UsageError& fault) {
        EXPECT_THAT(fault.what(), HasSubstr("5 x 3 x 7 x 100000 x 100000 x 100000 x 100000"));
    }
}

TEST(TableHeader, FaultsAreNamed)
{
    struct Case {
        std::function<void(TableHeader&)> spoil;
        std::string message;
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Case> cases = {
        {[](auto& h) { h.axes[1].values.clear(); }, "axis 'theta_o' is empty"},
        {[](auto& h) { h.axes[0].values[1] = 9; }, "axis 'theta_i' is not finite and strictly"},
        {[](auto& h) { h.axes[0].values[1] = 99; }, "axis 'theta_i' is not finite and strictly"},
        {[&](auto& h) { h.axes[0].values[1] = nan; }, "axis 'theta_i' is not finite and strictly"},
        {[](auto& h) { h.axes[1].name = "theta_i"; }, "two of the axis 'theta_i'"},
        {[](auto& h) { h.channels[1] = "theta_i"; }, "two of the channel 'theta_i'"},
        {[](auto& h) { h.channels[1] = "a,b"; }, "'a,b' holds a comma"},
        {[](auto& h) { h.unit = "1/sr\n"; }, "holds a comma, a quote or a control character"},
        {[](auto& h) { h.quantity = ""; }, "the quantity without a name"},
        {[](auto& h) { h.channels.clear(); }, "no channel"},
        {[](auto& h) { h.sweep_axes = 3; }, "no axis besides the swept ones"},
        {[&](auto& h) { h.attributes[1].second = nan; }, "attribute 'alpha' is not finite"},
        {[](auto& h) { h.attributes[1].first = "model"; }, "two of the attribute 'model'"},
    };
    for (const auto& [spoil, message] : cases) {
        auto header = test::small_header();
        EXPECT_NO_THROW(check(header));
        spoil(header);
        try {
            check(header);
            ADD_FAILURE() << "no fault, expected: " << message;
        } catch (const UsageError& fault) {
            EXPECT_THAT(fault.what(), HasSubstr(message));
        }
    }
}

TEST(TableHeader, MayFall)
{
    auto header = test::small_header();
    header.axes[0].values = {81, 63, 45, 27, 9};
    EXPECT_NO_THROW(check(header));
}

}  // namespace
}  // namespace gonio
