// SPDX-License-Identifier: Apache-2.0
// A table of f as a fitted lobe and a residual grid, and back.
#pragma once

#include <string>

#include "gonio/material.hpp"
#include "gonio/table.hpp"

namespace gonio {

/// The residual log(f / lobe) over theta_h, theta_d and phi_d up to 90 degrees where that is
/// possible, with the lobe's parameters as attributes lobe.* and the table's as table.*; NaN where
/// the table has no value. Numbers are rounded to multiples of a power of two that keeps f to
/// within `error` of itself. Throws UsageError, which names `name`, unless the table holds f and
/// model lebedev can read it.
Table compress(const Table& table, const std::string& name, double error);

/// How far a lobe with its residual is from a table, over its values of at least 1e-6 of the
/// greatest.
struct Loss {
    double largest = 0;             ///< relative error
    double rms = 0;                 ///< of the relative errors
    double largest_of_maximum = 0;  ///< absolute error as a part of the greatest value
};
Loss loss_of(const Lobe& lobe, const Table& table);

}  // namespace gonio
