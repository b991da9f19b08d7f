// SPDX-License-Identifier: Apache-2.0
// Tells a failure where in the scene it comes from.
#pragma once

#include "gonio/errors.hpp"
#include "gonio/scene.hpp"

namespace gonio {

/// Calls action(); a UsageError that it throws gets `where` in front.
template <class Action>
auto located(const Where& where, Action action)
{
    try {
        return action();
    } catch (const UsageError& fault) {
        throw UsageError(where + fault.what());
    }
}

}  // namespace gonio
