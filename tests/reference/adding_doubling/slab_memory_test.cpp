// SPDX-License-Identifier: Apache-2.0
// Slabs from memory are those that a solution gives.
#include "reference/adding_doubling/slab_memory.hpp"

#include <gtest/gtest.h>

#include "reference/adding_doubling.hpp"
#include "reference/layered_media.hpp"

namespace gonio::reference {
namespace {

using test::in_air;
using test::layer;

/// Media that differ from the first in one number, or in nothing.
std::vector<LayeredMedium> relatives()
{
    const Layer first = layer(1.4, 1, 50, 0.8, 0.02), below = layer(1.4, 2, 80, 0.7, 0.1);
    std::vector<LayeredMedium> all{in_air({first, below}), in_air({first, below})};
    for (const Layer& other :
         {layer(1.4, 1.1, 50, 0.8, 0.02), layer(1.4, 1, 51, 0.8, 0.02),
          layer(1.4, 1, 50, 0.7, 0.02), layer(1.4, 1, 50, 0.8, 0.03), layer(1.5, 1, 50, 0.8, 0.02)})
        all.push_back(in_air({other, below}));
    all.push_back(all.front());
    all.back().layers[0].phase = Isotropic{};
    all.push_back(all.front());
    all.back().layers[0].phase = TabulatedPhase{{-1, 1}, {1, 2}};
    all.push_back(all.back());
    std::get<TabulatedPhase>(all.back().layers[0].phase).value[1] = 3;
    return all;
}

TEST(SlabMemory, ChangesNoBit)
{
    SlabMemory memory;
    for (const LayeredMedium& medium : relatives())
        for (const int nodes : {12, 16}) {
            const LightRequest request{.incidence = {0.1}};
            const auto alone = solve_layers_once(medium, request, nodes);
            const auto shared = solve_layers_once(medium, request, nodes, std::ref(memory));
            EXPECT_EQ(alone.diffuse.budget.diffuse_reflectance,
                      shared.diffuse.budget.diffuse_reflectance);
            EXPECT_EQ(alone.collimated[0].budget.absorption,
                      shared.collimated[0].budget.absorption);
        }
}

TEST(SlabMemory, SolvesALayerOnce)
{
    SlabMemory memory;
    const auto request = LightRequest{.incidence = {0}};
    const auto media = relatives();
    solve_layers_once(media[0], request, 12, std::ref(memory));
    EXPECT_EQ(memory.size(), 2U);
    solve_layers_once(media[1], request, 12, std::ref(memory));
    EXPECT_EQ(memory.size(), 2U);
    solve_layers_once(media[2], request, 12, std::ref(memory));
    EXPECT_EQ(memory.size(), 3U);
}

}  // namespace
}  // namespace gonio::reference
