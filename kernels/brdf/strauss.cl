// SPDX-License-Identifier: Apache-2.0
// Strauss, A realistic lighting model for computer animators, IEEE CG&A 10(6), 1990: the value
// Q_d + Q_s.
#include "core/lobe.cl"

/// F(x) = (1/(x - k)^2 - 1/k^2)/(1/(1 - k)^2 - 1/k^2), k = 1.12: like Fresnel's. part: x, the angle
/// as a part of 90 degrees; rest: 1 - x
static inline real strauss_fresnel(real part, real rest)
{
    const float k = R(1.12), at_one = (R(2.0) * k - R(1.0)) / (R(0.12) * R(0.12));
    return part * (R(2.0) * k - part) * (R(1.0) / at_one) / square(R(0.12) + rest);
}

/// G(x) = (1/(1 - k)^2 - 1/(x - k)^2)/(1/(1 - k)^2 - 1/k^2), k = 1.01: shadowing.
static inline real strauss_shadowing(real rest)
{
    const float k = R(1.01), at_zero = (R(2.0) * k - R(1.0)) / (k * k);
    return rest * (R(0.02) + rest) * (R(1.0) / at_zero) / square(R(0.01) + rest);
}

static inline void strauss_eval(const strauss_params* p, const directions* d, real f[CHANNELS])
{
    const float s = p->smoothness, m = p->metalness, s3 = s * s * s;
    const float opaque = R(1.0) - p->transparency;
    // 1 - s^3 = (1 - s)(1 + s + s^2)
    const float rough = (R(1.0) - s) * (R(1.0) + s + s * s);
    const real diffuse = d->cos_i * ((R(1.0) - m * s) * rough * opaque);

    const float per_right_angle = R(2.0) / PI;
    const real part_i = angle_of(d->sin_i, d->cos_i) * per_right_angle;
    const real rest_i = angle_of(d->cos_i, d->sin_i) * per_right_angle;
    const real rest_o = angle_of(d->cos_o, d->sin_o) * per_right_angle;
    const real fresnel = strauss_fresnel(part_i, rest_i);
    const real j = fresnel * strauss_shadowing(rest_i) * strauss_shadowing(rest_o);
    const float r_n = opaque * s3;
    const real r_j = min((real)(R(1.0)), r_n + (r_n + R(0.1)) * j);
    const real power = power_of_cos_r(d, R(3.0) / (R(1.0) - s));
    // 1 + m (1 - F)(c - 1)
    FOR_CHANNELS(c)
    {
        const real color = (R(1.0) - m) + m * (fresnel + (R(1.0) - fresnel) * p->c[c]);
        f[c] = diffuse * p->c[c] + power * (r_j * color);
    }
}
