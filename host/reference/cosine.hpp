// SPDX-License-Identifier: Apache-2.0
// Half vectors, and cosines that keep the digits that large exponents magnify.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace gonio::reference {

/// The half vector h = (l + v)/|l + v| of unit vectors, and the cosine l.h = v.h = |l + v|/2: the
/// sum of products cancels where l and v graze from opposite sides.
struct Half {
    glm::dvec3 h;
    double cos_d;
};

inline Half half_vector(glm::dvec3 l, glm::dvec3 v)
{
    const glm::dvec3 sum = l + v;
    const double length = glm::length(sum);
    return {sum / length, length / 2};
}

/// tan^2 of the angle between n and a direction
inline double tangent2(glm::dvec3 w)
{
    return (w.x * w.x + w.y * w.y) / (w.z * w.z);
}

/// A cosine and its distance from 1, each with all its digits.
struct Cosine {
    double value, one_minus;
};

/// n.w
inline Cosine cosine_to_normal(glm::dvec3 w)
{
    return {w.z, (w.x * w.x + w.y * w.y) / (1 + w.z)};
}

/// r.v with r the mirror direction of l: 1 - r.v = |r - v|^2/2
inline Cosine cosine_to_mirror(glm::dvec3 l, glm::dvec3 v)
{
    const glm::dvec3 r(-l.x, -l.y, l.z), chord = r - v;
    return {glm::dot(r, v), glm::dot(chord, chord) / 2};
}

/// max(0, cosine)^exponent, and 0 at 0 for every exponent
inline double power(Cosine cosine, double exponent)
{
    if (cosine.value <= 0) return 0;
    const double log = cosine.value < 0.5 ? std::log(cosine.value) : std::log1p(-cosine.one_minus);
    return std::exp(exponent * log);
}

}  // namespace gonio::reference
