// SPDX-License-Identifier: Apache-2.0
// Makes the table of a job of integrals: computes, checks against the reference, writes.
#pragma once

#include <functional>

#include "compute/make_table.hpp"

namespace gonio {

/// As make_table(), for a job with cells in place of a grid. Throws RunError if an error that the
/// scene asks for is not reached, CheckFailed if the device disagrees with the reference.
MadeTable make_integrals(const Device& device, const Job& job,
                         const std::function<void(std::size_t)>& after_rows);

}  // namespace gonio
