// SPDX-License-Identifier: Apache-2.0
// The usual bake of a split sum, to compare with.
#pragma once

#include <cstddef>

namespace gonio::bench {

/// Scale and bias of GGX with height-correlated masking at n.v = mu, by importance sampling of
/// half vectors at `samples` points of Hammersley's set (Karis, Real shading in Unreal Engine 4,
/// SIGGRAPH course notes, 2013; masking as in Lagarde & de Rousiers, 2014). Cells of a table of
/// size x size: rows alpha = ((k + 0.5)/size)^2, columns mu = (k + 0.5)/size.
void hammersley_split_sum(float* scale, float* bias, std::size_t size, unsigned samples);

}  // namespace gonio::bench
