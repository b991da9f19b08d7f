// SPDX-License-Identifier: Apache-2.0
// The files that the build embeds as strings: kernels, what they share with C++, and data.
#pragma once

#include <span>
#include <string_view>

namespace gonio {

/// A file of the source tree. `path` is relative to kernels/, include/ or host/, whichever holds
/// it: "brdf/ward.cl", "gonio/shared/models.inc", "data/illuminants.csv".
struct EmbeddedFile {
    std::string_view path;
    std::string_view text;
};

/// Everything in kernels/ and include/gonio/shared/, sorted by folder and path.
std::span<const EmbeddedFile> kernel_files();

/// Everything in host/data/.
std::span<const EmbeddedFile> data_files();

/// The page of a report, and the library that draws its charts: "chart.min.js".
std::span<const EmbeddedFile> page_files();

}  // namespace gonio
