// SPDX-License-Identifier: Apache-2.0
// Skin that has a surface on both sides: an ear, a nostril, the web of a finger.
#pragma once

#include "gonio/layers.hpp"

namespace gonio {

/// A fold of that thickness, cm: the upper layers of skin in full on both sides as long as they
/// fit, and the next one between them, as thick as the rest of the fold, also where skin has less
/// of it. Below it is what skin has above it.
LayeredMedium fold_of(const LayeredMedium& skin, double thickness);

}  // namespace gonio
