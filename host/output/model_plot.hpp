// SPDX-License-Identifier: Apache-2.0
// One page about a material: its lobes at four angles of the light, and its directional albedo.
#pragma once

#include <filesystem>

#include "gonio/material.hpp"

namespace gonio {

/// Draws the double reference in the plane of incidence along x and the albedo against the angle of
/// the light, as .png or .svg: the same bytes for the same material. Throws UsageError for another
/// name, RunError where the disk refuses.
void write_model_plot(const std::filesystem::path& path, const Material& material);

}  // namespace gonio
