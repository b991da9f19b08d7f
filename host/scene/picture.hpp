// SPDX-License-Identifier: Apache-2.0
// The picture that a scene describes.
#pragma once

#include <filesystem>
#include <vector>

#include "scene/reader.hpp"

namespace gonio {

/// [picture]; meshes are found from `folder` on.
PictureRequest read_picture(const Value& value, const std::vector<SceneMaterial>& materials,
                            const std::filesystem::path& folder);

}  // namespace gonio
