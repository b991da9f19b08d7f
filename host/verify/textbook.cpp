// SPDX-License-Identifier: Apache-2.0
// Textbook forms in float32; the sources are those of the registry.
#include "verify/textbook.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace gonio::textbook {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

float number(const Lobe& lobe, std::string_view name)
{
    return static_cast<float>(lobe.number(lobe.model->index_of(name), 0));
}

float square(float x)
{
    return x * x;
}

/// tan^2 of the angle to the normal: 1 - cos^2 has lost it where the angle is small.
float tangent2(float cosine)
{
    return (1 - square(cosine)) / square(cosine);
}

float ggx_lobe(float alpha, glm::vec3 l, glm::vec3 v)
{
    const glm::vec3 h = glm::normalize(l + v);
    const float a2 = square(alpha);
    const float d = a2 / (pi * square(square(h.z) * (a2 - 1) + 1));
    const auto lambda = [&](float cosine) {
        return (std::sqrt(1 + a2 * tangent2(cosine)) - 1) / 2;
    };
    return d / (1 + lambda(l.z) + lambda(v.z)) / (4 * l.z * v.z);
}

/// Unpolarised; t0 + root loses what is left of it where k is large.
float conductor(float eta, float k, float cosine)
{
    const float c2 = square(cosine), s2 = 1 - c2;
    const float t0 = square(eta) - square(k) - s2;
    const float sum = std::sqrt(square(t0) + 4 * square(eta * k));
    const float a = std::sqrt((sum + t0) / 2);
    const float s = (sum + c2 - 2 * a * cosine) / (sum + c2 + 2 * a * cosine);
    const float t = c2 * sum + square(s2);
    const float u = 2 * a * cosine * s2;
    return s * (1 + (t - u) / (t + u)) / 2;
}

}  // namespace

float ggx(const Lobe& lobe, glm::vec3 l, glm::vec3 v)
{
    return ggx_lobe(number(lobe, "alpha_x"), l, v);
}

float ggx_conductor(const Lobe& lobe, glm::vec3 l, glm::vec3 v)
{
    const float cosine = glm::dot(v, glm::normalize(l + v));
    return ggx(lobe, l, v) * conductor(number(lobe, "eta"), number(lobe, "k"), cosine);
}

float beckmann(const Lobe& lobe, glm::vec3 l, glm::vec3 v)
{
    const float alpha = number(lobe, "alpha_x"), cosine = glm::normalize(l + v).z;
    const float d =
        std::exp(-tangent2(cosine) / square(alpha)) / (pi * square(alpha * square(cosine)));
    const auto lambda = [&](float z) {
        const float a = 1 / (alpha * std::sqrt(tangent2(z)));
        return (std::erf(a) - 1) / 2 + std::exp(-a * a) / (2 * a * std::sqrt(pi));
    };
    return d / (1 + lambda(l.z) + lambda(v.z)) / (4 * l.z * v.z);
}

float ward(const Lobe& lobe, glm::vec3 l, glm::vec3 v)
{
    const float x = number(lobe, "alpha_x"), y = number(lobe, "alpha_y");
    const glm::vec3 h = glm::normalize(l + v);
    const float phi = std::atan2(h.y, h.x), theta = std::acos(h.z);
    const float q =
        square(std::tan(theta)) * (square(std::cos(phi) / x) + square(std::sin(phi) / y));
    return number(lobe, "rho_s") * std::exp(-q) / (4 * pi * x * y * std::sqrt(l.z * v.z));
}

float phong(const Lobe& lobe, glm::vec3 l, glm::vec3 v)
{
    const float n = number(lobe, "exponent");
    const glm::vec3 r(-l.x, -l.y, l.z);
    return number(lobe, "rho_s") * (n + 2) / (2 * pi) * std::pow(std::max(glm::dot(r, v), 0.0F), n);
}

float blinn_phong(const Lobe& lobe, glm::vec3 l, glm::vec3 v)
{
    const float n = number(lobe, "exponent");
    return number(lobe, "rho_s") * (n + 2) * (n + 4) / (8 * pi * (n + std::exp2(-n / 2))) *
           std::pow(glm::normalize(l + v).z, n);
}

float ashikhmin_shirley(const Lobe& lobe, glm::vec3 l, glm::vec3 v)
{
    const float u = number(lobe, "n_u"), w = number(lobe, "n_v");
    const float r_s = number(lobe, "r_s"), r_d = number(lobe, "r_d");
    const glm::vec3 h = glm::normalize(l + v);
    const float cosine = glm::dot(v, h);
    const float exponent = (u * square(h.x) + w * square(h.y)) / (1 - square(h.z));
    const float fresnel = r_s + (1 - r_s) * std::pow(1 - cosine, 5.0F);
    const float specular = std::sqrt((u + 1) * (w + 1)) / (8 * pi) * std::pow(h.z, exponent) *
                           fresnel / (cosine * std::max(l.z, v.z));
    const auto entering = [](float z) { return 1 - std::pow(1 - z / 2, 5.0F); };
    return specular + 28 * r_d * (1 - r_s) / (23 * pi) * entering(l.z) * entering(v.z);
}

float oren_nayar(const Lobe& lobe, glm::vec3 l, glm::vec3 v)
{
    const float s2 = square(number(lobe, "sigma"));
    const float a = 1 - 0.5F * s2 / (s2 + 0.33F), b = 0.45F * s2 / (s2 + 0.09F);
    const float theta_i = std::acos(l.z), theta_o = std::acos(v.z);
    const glm::vec3 n(0, 0, 1);
    const float cosine =
        glm::dot(glm::normalize(l - n * l.z), glm::normalize(v - n * v.z));  // of the azimuth
    return number(lobe, "rho") / pi *
           (a + b * std::max(0.0F, cosine) * std::sin(std::max(theta_i, theta_o)) *
                    std::tan(std::min(theta_i, theta_o)));
}

float beckmann_kirchhoff(const Lobe& lobe, glm::vec3 l, glm::vec3 v)
{
    const float wavelength = number(lobe, "wavelength") / 1000, tau = number(lobe, "tau");
    const glm::vec3 sum = l + v;
    const float g = square(2 * pi * number(lobe, "sigma") / wavelength * sum.z);
    const float b = square(pi * tau / wavelength) * (square(sum.x) + square(sum.y));
    float series = 0, term = 1;
    for (int m = 1; m <= 1000; ++m) {
        term *= g / static_cast<float>(m);
        series += term / static_cast<float>(m) * std::exp(-b / static_cast<float>(m));
    }
    const glm::vec3 h = glm::normalize(sum);
    return square(glm::dot(v, h) / h.z) / (l.z * v.z) * pi * square(tau / wavelength) *
           std::exp(-g) * series;
}

}  // namespace gonio::textbook
