// SPDX-License-Identifier: Apache-2.0
// gonio skin --fit: parameters of a measured spectrum.
#pragma once

#include <string>
#include <vector>

#include "commands/skin_options.hpp"

namespace gonio {

/// Fits, prints what was found and how well it fits, and writes the files. Throws UsageError.
void run_skin_fit(const SkinOptions& options, const SkinTask& task,
                  const std::vector<std::string>& words);

}  // namespace gonio
