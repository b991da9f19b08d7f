// SPDX-License-Identifier: Apache-2.0
// The options of a grid on the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "gonio/scene.hpp"

namespace gonio {

struct GridOptions {
    std::string counts;  ///< "90x90x360"; empty where none were given
    std::string kind, samples = "centre", spacing = "linear", interpolation;

    void add_to(CLI::App& verb);
    /// Of the counts, or of the default ones. Throws UsageError where they are not those of its
    /// kind.
    Grid grid() const;
    /// Of no counts. Throws UsageError where there are some.
    GridFit fit() const;
};

}  // namespace gonio
