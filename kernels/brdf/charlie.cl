// SPDX-License-Identifier: Apache-2.0
// Estevez & Kulla, Production friendly microfacet sheen BRDF, SIGGRAPH course notes, 2017: c D V,
// D = (2 + 1/r) sin^(1/r) theta_h/(2 pi).
#include "core/lobe.cl"

static inline float charlie_between(float smooth, float rough, float weight)
{
    return smooth + (rough - smooth) * weight;
}

/// The fit to log Lambda: a/(1 + b x^c) + d x + e, between coefficients for roughness 0 and 1.
static inline real charlie_fit(float roughness, real x)
{
    const float weight = roughness * (R(2.0) - roughness);
    const float a = charlie_between(R(25.3245), R(21.5473), weight);
    const float b = charlie_between(R(3.32435), R(3.82987), weight);
    const float c = charlie_between(R(0.16801), R(0.19823), weight);
    const float d = charlie_between(R(-1.27393), R(-1.97760), weight);
    const float e = charlie_between(R(-4.85967), R(-4.32054), weight);
    // 0^c is 0: the bound keeps the logarithm finite.
    const real power = power_of_parts(parts_of_positive(max(x, (real)(R(1e-35)))), (real)(c));
    const real bounded = choose(less((real)(R(0.0)), x), power, (real)(R(0.0)));
    return a / (R(1.0) + b * bounded) + (d * x + e);
}

/// Lambda below 60 degrees is that above, turned about the point at 60 degrees.
static inline real charlie_lambda(float roughness, real cosine, real sine)
{
    const mask_t grazing = less(cosine, (real)(R(0.5)));
    const real one_minus = square(sine) / (R(1.0) + cosine);
    const real l = charlie_fit(roughness, choose(grazing, cosine, one_minus));
    const real at_half = charlie_fit(roughness, (real)(R(0.5)));
    return exp_of_negative(choose(grazing, -l, l - R(2.0) * at_half));
}

/// V = G/(4 (n.l)(n.v)): Neubelt & Pettineo, SIGGRAPH course notes, 2013, or Smith's.
static inline real charlie_visibility(const charlie_params* p, const directions* d)
{
    const real cos_cos = d->cos_i * d->cos_o;
    if (p->masking == charlie_masking_neubelt) return R(0.25) / (R(2.0) * d->mean_cos - cos_cos);
    const real masked = charlie_lambda(p->roughness, d->cos_i, d->sin_i) +
                        charlie_lambda(p->roughness, d->cos_o, d->sin_o);
    return R(0.25) / ((R(1.0) + masked) * cos_cos);
}

static inline void charlie_eval(const charlie_params* p, const directions* d, real f[CHANNELS])
{
    const float inverse = R(1.0) / p->roughness;
    const float norm = (R(2.0) + inverse) * (R(0.5) / PI);
    // 1/sin^2 = 1 + 1/tan^2. At h = n the bound leaves 3e-19 of the lobe and not 0.
    const real cot2 = R(1.0) / max(d->tan2_h, (real)(R(1e-37)));
    const real distribution =
        norm * power_of_parts(parts_of_sum((real)(R(1.0)), cot2), (real)(R(-0.5) * inverse));
    const real lobe = distribution * charlie_visibility(p, d);
    FOR_CHANNELS(c) f[c] = p->c[c] * lobe;
}
