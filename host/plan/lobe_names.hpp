// SPDX-License-Identifier: Apache-2.0
// What parameters are called among all lobes of a material.
#pragma once

#include <string>
#include <vector>

#include "gonio/job.hpp"

namespace gonio {

/// The parameters that a name stands for: two for a common name.
std::vector<std::string> parameters_of(const Model& model, const std::string& name);

/// What parameters of each lobe are called among all: "" for a single lobe, else the model's id
/// with a dot, and a number where the model is there more than once ("ward_2.").
std::vector<std::string> lobe_prefixes(const std::vector<Lobe>& lobes);

/// A swept parameter as an axis of a table.
Axis sweep_axis(const Sweep& sweep, const std::vector<Lobe>& lobes);

}  // namespace gonio
