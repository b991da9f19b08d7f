// SPDX-License-Identifier: Apache-2.0
// Lobes that add nothing.
#include "compute/idle_lobes.hpp"

#include <algorithm>

namespace gonio {

Material without_idle_lobes(const Material& material)
{
    Material rest = material;
    std::erase_if(rest.lobes, [](const Lobe& lobe) {
        return std::ranges::all_of(lobe.weight, [](double weight) { return weight == 0; });
    });
    const bool same = !rest.lobes.empty() && rest.channels() == material.channels();
    return same ? rest : material;
}

}  // namespace gonio
