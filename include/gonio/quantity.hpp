// SPDX-License-Identifier: Apache-2.0
// The registry of quantities as data: what tables can be asked for, as quantities.inc says.
#pragma once

#include <string_view>
#include <vector>

namespace gonio {

/// What a material is, and so which quantities it has: a model or a sum of lobes, or layers that
/// photons travel through, or skin.
enum class Substance { surface, layers, skin };

struct Quantity {
    struct AxisName {
        std::string_view name, unit;
    };

    std::string_view id, title, unit;
    Substance of;
    std::vector<AxisName> axes;             ///< from the outermost
    std::vector<std::string_view> solvers;  ///< that can give it; "auto" takes the first that fits

    bool on_grid() const;  ///< over a grid of direction pairs instead of axes of its own
};

const std::vector<Quantity>& quantities();

/// Throws UsageError with the nearest name if a substance has no such quantity.
const Quantity& find_quantity(std::string_view id, Substance of);

}  // namespace gonio
