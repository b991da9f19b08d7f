// SPDX-License-Identifier: Apache-2.0
// What a good C++ programmer would write instead. Compiled with -O3 -march=native -ffast-math
// -fopenmp.
#include "compute/peers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonio::bench {
namespace {

constexpr float pi = std::numbers::pi_v<float>;
float square(float x)
{
    return x * x;
}

/// What the table form sees of a cell: sums of squares from axis tables, as the kernels have them.
struct Cell {
    float cos_i, cos_o, tan2_h, sec2_h, cos2_d, mirror, cos_r, azimuth, mean_cos;
};

template <class Model>
void with_tables(const PeerGrid& grid, float* out)
{
    const std::size_t length = grid.phi.size();
    std::vector<float> cos2_half(length), cosine(length);
    for (std::size_t k = 0; k < length; ++k) {
        cos2_half[k] = square(std::cos(grid.phi[k] / 2));
        cosine[k] = std::cos(grid.phi[k]);
    }
#pragma omp parallel for collapse(2) schedule(static)
    for (std::size_t i = 0; i < grid.theta_i.size(); ++i)
        for (std::size_t o = 0; o < grid.theta_o.size(); ++o) {
            const float a = grid.theta_i[i], b = grid.theta_o[o];
            const float cos_i = std::cos(a), cos_o = std::cos(b),
                        sin_sin = std::sin(a) * std::sin(b);
            const float difference = square(std::tan((a - b) / 2)),
                        sum = square(std::tan((a + b) / 2));
            const float cos2_sum = square(std::cos((a + b) / 2)),
                        sin2_difference = square(std::sin((a - b) / 2));
            const float mean_cos = (cos_i + cos_o) / 2;
            float* row = out + (i * grid.theta_o.size() + o) * length;
            const float *half = cos2_half.data(), *delta = cosine.data();
#pragma omp simd
            for (std::size_t k = 0; k < length; ++k) {
                const float cos2_d = cos2_sum + sin_sin * half[k];
                const Cell cell{cos_i,
                                cos_o,
                                difference * (1 - half[k]) + sum * half[k],
                                cos2_d / square(mean_cos),
                                cos2_d,
                                2 * (sin2_difference + sin_sin * half[k]),
                                cos_i * cos_o - sin_sin * delta[k],
                                sin_sin * delta[k],
                                mean_cos};
                row[k] = Model::tables(cell);
            }
        }
}

struct Vector {
    float x, y, z;
};

float dot(Vector a, Vector b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Model>
void textbook(const PeerGrid& grid, float* out)
{
#pragma omp parallel for collapse(2) schedule(static)
    for (std::size_t i = 0; i < grid.theta_i.size(); ++i)
        for (std::size_t o = 0; o < grid.theta_o.size(); ++o) {
            float* row = out + (i * grid.theta_o.size() + o) * grid.phi.size();
            for (std::size_t k = 0; k < grid.phi.size(); ++k) {
                const float a = grid.theta_i[i], b = grid.theta_o[o], phi = grid.phi[k];
                const Vector l{std::sin(a), 0, std::cos(a)};
                const Vector v{std::sin(b) * std::cos(phi), std::sin(b) * std::sin(phi),
                               std::cos(b)};
                const Vector sum{l.x + v.x, l.y + v.y, l.z + v.z};
                const float scale = 1 / std::sqrt(dot(sum, sum));
                row[k] = Model::textbook(l, v, {sum.x * scale, sum.y * scale, sum.z * scale});
            }
        }
}

float schlick_fresnel(float f0, float c)
{
    return f0 + (1 - f0) * square(square(1 - c)) * (1 - c);
}

struct BlinnPhong {
    static constexpr float norm = 0.5F * 22 * 24 / (8 * pi * (20 + 1.0F / 1024));
    static float tables(const Cell& c) { return norm * std::exp(-10 * std::log(c.sec2_h)); }
    static float textbook(Vector, Vector, Vector h) { return norm * std::pow(h.z, 20.0F); }
};

struct Phong {
    static constexpr float norm = 0.5F * 22 / (2 * pi);
    static float tables(const Cell& c)
    {
        return c.cos_r > 0 ? norm * std::exp(20 * std::log(c.cos_r)) : 0;
    }
    static float textbook(Vector l, Vector v, Vector)
    {
        return norm * std::pow(std::max(0.0F, dot({-l.x, -l.y, l.z}, v)), 20.0F);
    }
};

struct CookTorrance {
    static constexpr float m2 = 0.09F, f0 = 1;
    static float tables(const Cell& c)
    {
        const float d = std::exp(-c.tan2_h / m2) * square(c.sec2_h) / (pi * m2);
        const float v = std::min(0.25F / (c.cos_i * c.cos_o),
                                 0.5F * c.mean_cos / (c.cos2_d * std::max(c.cos_i, c.cos_o)));
        return d * v * schlick_fresnel(f0, std::sqrt(c.cos2_d));
    }
    static float textbook(Vector l, Vector v, Vector h)
    {
        const float delta = std::acos(h.z), v_h = dot(v, h);
        const float d = std::exp(-square(std::tan(delta)) / m2) / (pi * m2 * square(square(h.z)));
        const float g = std::min({1.0F, 2 * h.z * v.z / v_h, 2 * h.z * l.z / v_h});
        return d * g * schlick_fresnel(f0, v_h) / (4 * l.z * v.z);
    }
};

struct Ggx {
    static constexpr float a2 = 0.04F, f0 = 1;
    static float tables(const Cell& c)
    {
        const float d = square(c.sec2_h / (1 + c.tan2_h / a2)) / (pi * a2);
        const float v = 0.5F / (c.cos_o * std::sqrt(a2 * (1 - square(c.cos_i)) + square(c.cos_i)) +
                                c.cos_i * std::sqrt(a2 * (1 - square(c.cos_o)) + square(c.cos_o)));
        return d * v * schlick_fresnel(f0, std::sqrt(c.cos2_d));
    }
    static float textbook(Vector l, Vector v, Vector h)
    {
        const auto lambda = [](float c) {
            return (std::sqrt(1 + a2 * (1 / square(c) - 1)) - 1) / 2;
        };
        const float d = a2 / (pi * square(square(h.z) * (a2 - 1) + 1));
        return d * schlick_fresnel(f0, dot(v, h)) /
               ((1 + lambda(l.z) + lambda(v.z)) * 4 * l.z * v.z);
    }
};

struct Ward {
    static constexpr float a2 = 0.04F;
    static float tables(const Cell& c)
    {
        return 0.5F * std::exp(-c.tan2_h / a2) / (4 * pi * a2 * std::sqrt(c.cos_i * c.cos_o));
    }
    static float textbook(Vector l, Vector v, Vector h)
    {
        return 0.5F * std::exp(-square(std::tan(std::acos(h.z))) / a2) /
               (4 * pi * a2 * std::sqrt(l.z * v.z));
    }
};

struct OrenNayar {
    static constexpr float sigma2 = 0.121847F;
    static constexpr float a = 1 - 0.5F * sigma2 / (sigma2 + 0.33F),
                           b = 0.45F * sigma2 / (sigma2 + 0.09F);
    static float tables(const Cell& c)
    {
        return 0.5F / pi * (a + b * std::max(0.0F, c.azimuth) / std::max(c.cos_i, c.cos_o));
    }
    static float textbook(Vector l, Vector v, Vector)
    {
        const float i = std::acos(l.z), o = std::acos(v.z);
        const float cos_phi = std::cos(std::atan2(v.y, v.x) - std::atan2(l.y, l.x));
        return 0.5F / pi *
               (a +
                b * std::max(0.0F, cos_phi) * std::sin(std::max(i, o)) * std::tan(std::min(i, o)));
    }
};

}  // namespace

const std::vector<Peers>& peers()
{
    static const std::vector<Peers> all{
        {"phong", with_tables<Phong>, textbook<Phong>},
        {"blinn_phong", with_tables<BlinnPhong>, textbook<BlinnPhong>},
        {"ward", with_tables<Ward>, textbook<Ward>},
        {"cook_torrance", with_tables<CookTorrance>, textbook<CookTorrance>},
        {"torrance_sparrow", with_tables<Ggx>, textbook<Ggx>},
        {"oren_nayar", with_tables<OrenNayar>, textbook<OrenNayar>},
    };
    return all;
}

}  // namespace gonio::bench
