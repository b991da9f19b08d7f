// SPDX-License-Identifier: Apache-2.0
// Colorimetry with the tables of the CIE.
#include "gonio/colour.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <numbers>

#include "gonio/errors.hpp"
#include "output/tone.hpp"
#include "skin/spectrum.hpp"

namespace gonio {
namespace {

constexpr double first = 380, last = 780, widest_step = 20;  // nm

/// D65 times the colour matching functions, in steps of 5 nm, so that Y of white is 100.
struct Observer {
    std::vector<double> wavelengths;
    std::vector<glm::dvec3> weights;
    glm::dvec3 white{0};

    Observer()
    {
        const auto column = [](const char* name) {
            return skin::built_in_spectrum("cie_1931_d65.csv", name);
        };
        const auto x = column("x"), y = column("y"), z = column("z"), d65 = column("D65");
        for (std::size_t k = 0; k < d65.values().size(); ++k) {
            const double at = d65.wavelengths()[k];
            if (at < first || at > last) continue;
            wavelengths.push_back(at);
            weights.push_back(d65.values()[k] *
                              glm::dvec3(x.values()[k], y.values()[k], z.values()[k]));
            white += weights.back();
        }
        for (glm::dvec3& weight : weights) weight *= 100 / white.y;
        white *= 100 / white.y;
    }
};

const Observer& observer()
{
    static const Observer standard;
    return standard;
}

/// CIE 15: cube root, and a line near black.
double lightness_of(double ratio)
{
    constexpr double knee = 216.0 / 24389, slope = 24389.0 / 27;
    return ratio > knee ? std::cbrt(ratio) : (slope * ratio + 16) / 116;
}

}  // namespace

bool has_colour(const std::vector<double>& wavelengths)
{
    const auto leaves_a_gap = [](double a, double b) { return b - a > widest_step; };
    return wavelengths.size() > 1 && wavelengths.front() <= first && wavelengths.back() >= last &&
           std::ranges::adjacent_find(wavelengths, leaves_a_gap) == wavelengths.end();
}

glm::dvec3 tristimulus(const std::vector<double>& wavelengths,
                       const std::vector<double>& reflectance)
{
    if (!has_colour(wavelengths))
        throw UsageError("a colour needs a spectrum from 380 to 780 nm in steps of up to 20 nm");
    const skin::Spectrum spectrum("the spectrum", wavelengths, reflectance);
    glm::dvec3 sum{0};
    for (std::size_t k = 0; k < observer().weights.size(); ++k)
        sum += spectrum.at(observer().wavelengths[k]) * observer().weights[k];
    return sum;
}

glm::dvec3 linear_srgb(const glm::dvec3& xyz)
{
    // IEC 61966-2-1, amendment 1; columns.
    const glm::dmat3 to_rgb{{3.2406255, -0.9689307, 0.0557101},
                            {-1.5372080, 1.8757561, -0.2040211},
                            {-0.4986286, 0.0415175, 1.0569959}};
    return to_rgb * xyz / 100.0;
}

glm::ivec3 srgb_bytes(const glm::dvec3& linear)
{
    glm::ivec3 bytes;
    for (int c = 0; c < 3; ++c)
        bytes[c] = static_cast<int>(
            std::lround(255 * encode(static_cast<float>(glm::clamp(linear[c], 0.0, 1.0)))));
    return bytes;
}

glm::dvec3 cielab(const glm::dvec3& xyz)
{
    const glm::dvec3 ratio = xyz / observer().white;
    const double fx = lightness_of(ratio.x), fy = lightness_of(ratio.y), fz = lightness_of(ratio.z);
    return {116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)};
}

double individual_typology_angle(const glm::dvec3& lab)
{
    return std::atan2(lab.x - 50, lab.z) * 180 / std::numbers::pi;
}

ReflectanceColour colour_of(const std::vector<double>& wavelengths,
                            const std::vector<double>& reflectance)
{
    const glm::dvec3 xyz = tristimulus(wavelengths, reflectance);
    const glm::dvec3 linear = linear_srgb(xyz), lab = cielab(xyz);
    return {xyz, linear, srgb_bytes(linear), lab, individual_typology_angle(lab)};
}

}  // namespace gonio
