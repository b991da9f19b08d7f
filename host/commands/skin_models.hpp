// SPDX-License-Identifier: Apache-2.0
// The listing of skin models.
#pragma once

#include <string>

namespace gonio {

/// All models, or all about one of them. Throws UsageError with the nearest name.
void print_skin_models(const std::string& name, bool json);

}  // namespace gonio
