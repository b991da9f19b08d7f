// SPDX-License-Identifier: Apache-2.0
// Photons on the device in every medium of the files that adding-doubling is compared with other
// programs on (tests/reference/adding_doubling_test.cpp): all of the budget, the part that each
// layer absorbs too, against adding-doubling.
#include <gtest/gtest.h>

#include "photon/photon_fixtures.hpp"
#include "reference/layer_fixtures.hpp"

namespace gonio::test {
namespace {

void compare_slabs(std::uint64_t photons)
{
    ZTest test;
    for (const CsvRow& row : read_csv("layers/slabs.csv"))
        compare_with_exact(test,
                           "n = " + row.text("n") + ", g = " + row.text("g") +
                               ", a = " + row.text("a") + ", b = " + row.text("b"),
                           slab_of(row), photons);
    test.expect_only_noise();
}

TEST(PhotonRows, OfSlabs)
{
    compare_slabs(20'000);
}

TEST(LongPhotonRows, OfSlabs)
{
    compare_slabs(1'000'000);
}

TEST(LongPhotonRows, OfSkin)
{
    ZTest test;
    for (const auto& [name, medium] : skin_models())
        compare_with_exact(test, name, medium, 200'000);
    test.expect_only_noise();
}

}  // namespace
}  // namespace gonio::test
