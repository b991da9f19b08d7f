// SPDX-License-Identifier: Apache-2.0
// Builds programs from the embedded kernels, or from the folder that GONIO_KERNELS names.
#pragma once

#include <string>
#include <vector>

#include "opencl/state.hpp"

namespace gonio {

/// Text behind all #include "..." of `text`: each file once, .inc files every time, with #line so
/// that a build log names the real file. Throws RunError for a file that does not exist.
std::string flattened(const std::string& text, const std::string& name);

/// preamble: the program's first lines (they may include kernel files); entry: the kernel file with
/// the entry point; definitions: "NAME=VALUE" for -D; WIDTH is added. Programs are kept: the same
/// text and options are built once. Throws KernelBuildError with options, log and the place of the
/// saved source.
cl::Program build_program(Device::State& device, const std::string& preamble,
                          const std::string& entry, std::vector<std::string> definitions,
                          unsigned width);

}  // namespace gonio
