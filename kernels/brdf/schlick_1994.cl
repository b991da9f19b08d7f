// SPDX-License-Identifier: Apache-2.0
// Schlick, CGF 13(3), 1994: S(u) G(n.l) G(n.v) Z(t) A(w)/(4 pi (n.l)(n.v)).
#include "core/lobe.cl"

/// The arithmetic-geometric mean of 1 and p for p >= 1e-4, to rounding.
static inline float schlick_1994_mean(float p)
{
    float a = R(1.0), b = p;
    for (int k = 0; k < 6; ++k) {
        const float mean = R(0.5) * (a + b);
        b = sqrt(a * b);
        a = mean;
    }
    return a;
}

/// A(w) = sqrt(p/(p^2 - p^2 w^2 + w^2)), w the cosine between x and the tangential part of h; its
/// mean over all azimuths is sqrt(p)/agm(1, p). At h = n, which has no azimuth, w is 0.
static inline real schlick_1994_azimuth(const schlick_1994_params* p, const directions* d)
{
#if ISOTROPIC
    return (real)(R(1.0));
#else
    const float iso = p->isotropy;
    const real x2 = square(d->slope_x), y2 = square(d->slope_y);
    const mask_t upright = less(x2 + y2, (real)(R(1e-12)));
    const real below = choose(upright, (real)(iso * iso), square(iso) * y2 + x2);
    const real above = choose(upright, (real)(R(1.0)), x2 + y2);
    const real printed = sqrt(iso * (above / below));
    return p->azimuth == schlick_1994_azimuth_normalised
               ? printed * (schlick_1994_mean(iso) / sqrt(iso))
               : printed;
#endif
}

/// G(x)/x with G(x) = x/(r - r x + x), or 1/x
static inline real schlick_1994_masking_over_cosine(const schlick_1994_params* p, real x)
{
    if (p->masking == schlick_1994_masking_none) return R(1.0) / x;
    return R(1.0) / (p->roughness * (R(1.0) - x) + x);
}

static inline void schlick_1994_eval(const schlick_1994_params* p, const directions* d,
                                     real f[CHANNELS])
{
    // Z(t) = r/(1 + r t^2 - t^2)^2 with t = n.h: 1/t^2 is sec^2, and 1/t^2 - 1 is tan^2.
    const real z = p->roughness * square(d->sec2_h / (d->tan2_h + p->roughness));
    const real masked = schlick_1994_masking_over_cosine(p, d->cos_i) *
                        schlick_1994_masking_over_cosine(p, d->cos_o);
    const real lobe = (R(0.25) / PI) * masked * z * schlick_1994_azimuth(p, d);
    const real cos_d = sqrt(d->cos2_d);
    FOR_CHANNELS(c) f[c] = lobe * fresnel_schlick(p->f0[c], cos_d);
}
