// SPDX-License-Identifier: Apache-2.0
// Forecasts by solver.
#pragma once

#include "plan/forecast.hpp"

namespace gonio {

/// Of a grid: by some rows of it from the reference, which tell what to check and to write takes.
Forecast grid_forecast(const Device& device, const Job& job);

/// Of integrals: by some of their cells.
Forecast integral_forecast(const Device& device, const Job& job);

/// Of layers without noise: by the first of their solutions.
Forecast exact_forecast(const Job& job);

/// Of layers by Monte Carlo: by some of their photons.
Forecast photon_forecast(const Device& device, const Job& job);

/// Of light that spreads in skin: by some photons in one of its sets.
Forecast profile_forecast(const Device& device, const Job& job);

}  // namespace gonio
