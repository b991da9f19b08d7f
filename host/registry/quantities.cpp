// SPDX-License-Identifier: Apache-2.0
// The registry of quantities as data, made from quantities.inc.
#include <fmt/format.h>

#include <algorithm>

#include "gonio/errors.hpp"
#include "gonio/model.hpp"
#include "gonio/quantity.hpp"

namespace gonio {

bool Quantity::on_grid() const
{
    return axes.size() == 1 && axes.front().name == "grid";
}

const std::vector<Quantity>& quantities()
{
#define AXIS(name, unit) {#name, unit},
#define GRID AXIS(grid, "")
#define SOLVER(name) #name,
#define QUANTITY(id, title, unit, of, axes, solvers) \
    {#id, title, unit, Substance::of, {axes}, {solvers}},
    static const std::vector<Quantity> all = {
#include "gonio/shared/quantities.inc"
    };
#undef SOLVER
#undef GRID
#undef AXIS
    return all;
}

const Quantity& find_quantity(std::string_view id, Substance of)
{
    std::vector<std::string_view> names;
    for (const Quantity& quantity : quantities()) {
        if (quantity.of != of) continue;
        if (quantity.id == id) return quantity;
        names.push_back(quantity.id);
    }
    throw UsageError(fmt::format("there is no quantity `{}`{}", id, suggestion(id, names)));
}

}  // namespace gonio
