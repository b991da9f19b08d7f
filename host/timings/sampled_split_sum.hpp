// SPDX-License-Identifier: Apache-2.0
// The usual bake of a split sum, to compare with.
#pragma once

#include <cstddef>
#include <vector>

namespace gonio {

enum class SampleSet { hammersley, random };

struct SampledSplitSum {
    std::vector<float> scale, bias;
};

/// Scale and bias of GGX with height-correlated masking at n.v = mu, by importance sampling of
/// half vectors at the points of a set (Karis, Real shading in Unreal Engine 4, SIGGRAPH course
/// notes, 2013; masking as in Lagarde & de Rousiers, 2014), in float on all processors. Cells of a
/// table of size x size: rows alpha = ((k + 0.5)/size)^2, columns mu = (k + 0.5)/size.
SampledSplitSum sampled_split_sum(std::size_t size, unsigned samples, SampleSet set);

}  // namespace gonio
