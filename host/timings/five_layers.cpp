// SPDX-License-Identifier: Apache-2.0
// The medium in which generators of random numbers are compared.
#include "timings/five_layers.hpp"

#include <fmt/format.h>

#include <cmath>

#include "reference/adding_doubling.hpp"

namespace gonio {

LayeredMedium five_layers()
{
    const auto layer = [](double mua, double mus, double g, double n, double d) {
        return Layer{mua, mus, n, d, HenyeyGreenstein{g}};
    };
    return {.layers = {layer(4.3, 107, 0.79, 1.5, 0.01), layer(2.7, 187, 0.82, 1.4, 0.02),
                       layer(3.3, 192, 0.82, 1.4, 0.02), layer(2.7, 187, 0.82, 1.4, 0.09),
                       layer(3.4, 194, 0.82, 1.4, 0.06)}};
}

double right_transmittance()
{
    return reference::solve_layers_once(five_layers(), {.incidence = {0}}, 96)
        .collimated[0]
        .budget.diffuse_transmittance;
}

BenchPoint compared(std::string_view generator, std::size_t photons, const Quartiles& took,
                    const Fraction& found, double right)
{
    return {std::string(generator),
            fmt::format("{} photons", photons),
            took,
            exactly(std::abs(found.mean - right) / found.error),
            false,
            {{"relative_bias", found.mean / right - 1},
             {"relative_standard_error", found.error / right}}};
}

}  // namespace gonio
