// SPDX-License-Identifier: Apache-2.0
// Layers of a fold, from one surface to the other.
#include "skin/fold.hpp"

#include <cstddef>

namespace gonio {

LayeredMedium fold_of(const LayeredMedium& skin, double thickness)
{
    LayeredMedium fold{.n_above = skin.n_above, .n_below = skin.n_above};
    double depth = 0;
    std::size_t whole = 0;
    for (; whole + 1 < skin.layers.size(); ++whole) {
        const Layer& layer = skin.layers[whole];
        if (depth + layer.d >= thickness / 2) break;
        depth += layer.d;
        fold.layers.push_back(layer);
    }
    Layer middle = skin.layers[whole];
    middle.d = thickness - 2 * depth;
    fold.layers.push_back(middle);
    for (std::size_t k = whole; k-- > 0;) fold.layers.push_back(skin.layers[k]);
    return fold;
}

}  // namespace gonio
