// SPDX-License-Identifier: Apache-2.0
// Ashikhmin & Shirley, An anisotropic Phong BRDF model, JGT 5(2), 2000.
#include "core/lobe.cl"

/// (n.h)^(e + 1) with e = (n_u h.x^2 + n_v h.y^2)/(1 - (n.h)^2); 1 at h = n.
static inline real ashikhmin_shirley_power(const ashikhmin_shirley_params* p, const directions* d)
{
#if ISOTROPIC
    return power_of_cos_h(d, (real)(p->n_u + R(1.0)));
#else
    const real stretched = p->n_u * square(d->slope_x) + p->n_v * square(d->slope_y);
    const real exponent = R(1.0) + stretched / max(d->tan2_h, (real)(R(1e-30)));
    return power_of_cos_h(d, exponent);
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

/// How many samples are of the diffuse lobe.
static inline float ashikhmin_shirley_diffuse_share(const ashikhmin_shirley_params* p)
{
    float base = R(0.0);
    FOR_CHANNELS(c) base = max(base, p->r_d[c] * (R(1.0) - p->r_s[c]));
    return base > R(0.0) ? R(0.5) : R(0.0);
}

/// Eqs. 6 and 8: half vectors with sqrt((n_u + 1)(n_v + 1))/(2 pi) (n.h)^e, over 4 (l.h); and the
/// cosine for the diffuse lobe.
static inline real ashikhmin_shirley_pdf(const ashikhmin_shirley_params* p, const directions* d)
{
    const float share = ashikhmin_shirley_diffuse_share(p);
    const float norm = sqrt((p->n_u + R(1.0)) * (p->n_v + R(1.0))) * (R(1.0) / (R(8.0) * PI));
    const real specular = norm * ashikhmin_shirley_power(p, d) / d->mean_cos;
    return (R(1.0) - share) * specular + share * (R(1.0) / PI) * d->cos_o;
}

/// Eqs. 9 and 10.
static inline mirror_offset ashikhmin_shirley_sample(const ashikhmin_shirley_params* p,
                                                     const fixed_light* l, stream* random)
{
    const mask_t is_diffuse =
        less(uniform_of(next_word(random)), (real)(ashikhmin_shirley_diffuse_share(p)));
    const mirror_offset diffuse = about_normal(l, random);
    const real u = uniform_of(next_word(random));
    half_vector h =
        stretched_normal((real)(R(1.0)), even_azimuth(next_word(random)),
                         R(1.0) / sqrt(p->n_u + R(1.0)), R(1.0) / sqrt(p->n_v + R(1.0)));
    // (n_u + 1) cos^2 phi + (n_v + 1) sin^2 phi is 1 over the squared length.
    const real length2 = square(h.x) + square(h.y);
    const real stretch = sqrt(tan2_of_root(u, R(1.0) / length2) / length2);
    h.x *= stretch;
    h.y *= stretch;
    return choose_offset(is_diffuse, diffuse, reflected(l, h));
}
