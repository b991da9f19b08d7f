// SPDX-License-Identifier: Apache-2.0
// Gauss rules, made once.
#pragma once

#include "reference/gauss_legendre.hpp"

namespace gonio {

/// The rule of that order, kept for the next who asks.
const reference::QuadratureRule& rule_of(int order);

}  // namespace gonio
