// SPDX-License-Identifier: Apache-2.0
// The medium of the benchmarks of light in layers.
#include "timings/skin.hpp"

#include "gonio/skin.hpp"

namespace gonio {

LayeredMedium benchmark_skin()
{
    return Skin(find_skin_model("meglinski_2002")).layers_at(633);
}

reference::LightBudget exact_light(const LayeredMedium& medium)
{
    return reference::solve_layers_once(medium, {.incidence = {0}}, 160).collimated[0].budget;
}

}  // namespace gonio
