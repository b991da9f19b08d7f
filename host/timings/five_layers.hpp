// SPDX-License-Identifier: Apache-2.0
// The medium in which generators of random numbers are compared, where MCML's shows.
#pragma once

#include <cstddef>
#include <string_view>

#include "gonio/layers.hpp"
#include "gonio/photons.hpp"
#include "timings/report.hpp"

namespace gonio {

/// Of photons, from whose spread comes the standard error.
inline constexpr std::size_t generator_batches = 64;

/// Five layers of skin at 633 nm: Tuchin 1997, as GPU-MCML ships them.
LayeredMedium five_layers();

/// Their diffuse transmittance under a pencil beam, by adding-doubling.
double right_transmittance();

/// How many standard errors a transmittance that was found with a generator is off.
BenchPoint compared(std::string_view generator, std::size_t photons, const Quartiles& took,
                    const Fraction& found, double right);

}  // namespace gonio
