// SPDX-License-Identifier: Apache-2.0
// References by name, and directions by angle, for every test that compares with them.
#pragma once

#include <array>
#include <functional>
#include <glm/vec3.hpp>
#include <string_view>
#include <vector>

#include "gonio/material.hpp"

namespace gonio {

using Brdf = std::function<double(glm::dvec3 l, glm::dvec3 v)>;

/// Unit vector of polar angle and azimuth in degrees.
glm::dvec3 direction(double theta, double phi);

/// Unit vector with that cosine to the normal, exactly, and an azimuth in radians.
glm::dvec3 direction_of_cosine(double cosine, double phi);

/// The lobe that a text like "ward form=duer alpha=0.2" describes.
Lobe lobe_of(std::string_view text);

/// The reference of lobe_of(text), channel 0, with its parameters not rounded.
Brdf reference_of(std::string_view text, Measure measure = Measure::brdf);

/// Light and viewer of the four columns of golden_values(): (30, 0)-(30, 180), (45, 0)-(20, 150),
/// (80, 10)-(85, 200), (60, 40)-(50, 45) degrees.
struct Geometry {
    glm::dvec3 l, v;
};
const std::array<Geometry, 4>& golden_geometries();

/// A lobe's value or BRDF in those geometries to nine digits, from an independent program in
/// Python.
struct Golden {
    const char* lobe;
    Measure measure;
    std::array<const char*, 4> printed;
};
const std::vector<Golden>& golden_values();

}  // namespace gonio
