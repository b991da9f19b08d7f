// SPDX-License-Identifier: Apache-2.0
// The registry of quantities.
#include "gonio/quantity.hpp"

#include <gtest/gtest.h>

#include <set>

#include "gonio/errors.hpp"

namespace gonio {
namespace {

TEST(Quantities, AreComplete)
{
    std::set<std::pair<std::string_view, Substance>> seen;
    for (const Quantity& quantity : quantities()) {
        EXPECT_TRUE(seen.emplace(quantity.id, quantity.of).second) << quantity.id << " twice";
        EXPECT_FALSE(quantity.title.empty()) << quantity.id;
        EXPECT_FALSE(quantity.unit.empty()) << quantity.id;
        EXPECT_FALSE(quantity.solvers.empty()) << quantity.id;
        EXPECT_EQ(&find_quantity(quantity.id, quantity.of), &quantity);
    }
    EXPECT_TRUE(find_quantity("brdf", Substance::surface).on_grid());
    EXPECT_EQ(find_quantity("brdf_cosine", Substance::surface).unit, "1/sr");
    EXPECT_THROW(find_quantity("dfg", Substance::layers), UsageError);
}

}  // namespace
}  // namespace gonio
