// SPDX-License-Identifier: Apache-2.0
// How much light a model reflects at most.
#pragma once

#include <string>

#include "gonio/device.hpp"
#include "gonio/model.hpp"

namespace gonio {

/// The largest directional albedo found, a bound of its error, and where: "n.l = 0.05, form =
/// phong_1975", naming what is not the default.
struct Gain {
    double albedo = 0, error = 0;
    std::string where;
};

/// Over every option of the model, eight values of each number, its default and both ends among
/// them, and n.l from 1 to 0.01. Reflectances and colours are 1; roughness along x and y is the
/// same, and numbers of several channels and wavelengths are the default.
Gain largest_albedo(const Device& device, const Model& model);

}  // namespace gonio
