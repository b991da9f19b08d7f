// SPDX-License-Identifier: Apache-2.0
// What a picture computes, and what it leaves out because nothing in it needs that.
#pragma once

#include <string>
#include <vector>

#include "gonio/scene.hpp"
#include "plan/explain.hpp"

namespace gonio {

/// Something that is computed.
struct PictureStage {
    std::string what;
    std::string kernel = {};                    ///< file of its program, empty without one
    std::vector<std::string> definitions = {};  ///< "NAME=VALUE"
    double share = 0;  ///< of all work, about; 0 where it takes next to none
};

struct PicturePlan {
    std::vector<PictureStage> stages;
    std::vector<LeftOut> left_out;
};

/// As far as it can be told without a ray: make_picture() also leaves out what no ray meets. Throws
/// as picture_material().
PicturePlan explain(const Device& device, const PictureRequest& picture,
                    const std::vector<SceneMaterial>& materials);

}  // namespace gonio
