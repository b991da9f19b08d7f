// SPDX-License-Identifier: Apache-2.0
// Colours of reflectance spectra: in daylight (D65), for the CIE 1931 observer of 2 degrees.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

namespace gonio {

/// Whether a spectrum at these wavelengths (nm, ascending) has a colour: 380 to 780 are covered, in
/// steps of up to 20.
bool has_colour(const std::vector<double>& wavelengths);

/// X, Y, Z of a reflectance, in steps of 5 nm between which it is linear; Y is 100 for a perfect
/// diffuser (CIE 15). Throws UsageError unless has_colour().
glm::dvec3 tristimulus(const std::vector<double>& wavelengths,
                       const std::vector<double>& reflectance);

/// X, Y, Z to linear sRGB (IEC 61966-2-1); 1 is white, and colours outside have negative numbers.
glm::dvec3 linear_srgb(const glm::dvec3& xyz);

/// Linear sRGB, encoded, as bytes; what does not fit is cut.
glm::ivec3 srgb_bytes(const glm::dvec3& linear);

/// X, Y, Z to L*, a*, b* with the white of D65 (CIE 15).
glm::dvec3 cielab(const glm::dvec3& xyz);

/// Individual typology angle of skin: atan((L* - 50) / b*), degrees (Chardon, Cretois, Hourseau,
/// Int. J. Cosmet. Sci. 13, 1991).
double individual_typology_angle(const glm::dvec3& lab);

/// All of these for one reflectance.
struct ReflectanceColour {
    glm::dvec3 xyz, linear;
    glm::ivec3 srgb;
    glm::dvec3 lab;
    double typology_angle;  ///< degrees
};

/// Throws UsageError unless has_colour().
ReflectanceColour colour_of(const std::vector<double>& wavelengths,
                            const std::vector<double>& reflectance);

}  // namespace gonio
