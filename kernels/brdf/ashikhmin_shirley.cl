// SPDX-License-Identifier: Apache-2.0
// Ashikhmin & Shirley, An anisotropic Phong BRDF model, JGT 5(2), 2000.
#include "core/lobe.cl"

/// (n.h)^(e + 1) with e = (n_u h.x^2 + n_v h.y^2)/(1 - (n.h)^2); 1 at h = n.
static inline real ashikhmin_shirley_power(const ashikhmin_shirley_params* p, const directions* d)
{
#if ISOTROPIC
    return power_of_cos_h(d, p->n_u + R(1.0));
#else
    const real stretched = p->n_u * square(d->slope_x) + p->n_v * square(d->slope_y);
    const real exponent = R(1.0) + stretched / max(d->tan2_h, (real)(R(1e-30)));
    return exp_of_negative(R(0.5) * exponent * log_of_one_plus(d->tan2_h));
#endif
}

/// 1 - (1 - cos/2)^5, as a geometric series.
static inline real ashikhmin_shirley_entering(real cosine)
{
    const real x = R(1.0) - R(0.5) * cosine;
    return R(0.5) * cosine * (R(1.0) + x * (R(1.0) + x * (R(1.0) + x * (R(1.0) + x))));
}

/// sqrt((n_u + 1)(n_v + 1))/(8 pi) (n.h)^e F(k.h)/((k.h) max(n.l, n.v)), and the diffuse lobe
/// 28 R_d (1 - R_s)/(23 pi) (1 - (1 - n.l/2)^5)(1 - (1 - n.v/2)^5).
static inline void ashikhmin_shirley_eval(const ashikhmin_shirley_params* p, const directions* d,
                                          real f[CHANNELS])
{
    const float norm = sqrt((p->n_u + R(1.0)) * (p->n_v + R(1.0))) * (R(1.0) / (R(8.0) * PI));
    // 1/(k.h) = n.h/mean_cos
    const real scale = norm / (d->mean_cos * max(d->cos_i, d->cos_o));
    const real lobe = scale * ashikhmin_shirley_power(p, d);
    const real cos_d = sqrt(d->cos2_d);
    const real entering =
        ashikhmin_shirley_entering(d->cos_i) * ashikhmin_shirley_entering(d->cos_o);
    const real diffuse = (R(28.0) / (R(23.0) * PI)) * entering;
    FOR_CHANNELS(c)
    {
        const float base = p->r_d[c] * (R(1.0) - p->r_s[c]);
        f[c] = lobe * fresnel_schlick(p->r_s[c], cos_d) + diffuse * base;
    }
}
