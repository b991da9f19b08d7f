// SPDX-License-Identifier: Apache-2.0
// Torrance & Sparrow, JOSA 57, 1967, in the form of Walter et al., EGSR 2007, eq. 20:
// F D G2/(4 cos_i cos_o), anisotropic.
#include "core/lobe.cl"

/// D, and G2/(4 cos_i cos_o) by Smith's masking: Heitz, JCGT 3(2), 2014, eqs. 98 and 99.
static inline real torrance_sparrow_smith(const torrance_sparrow_params* p, const directions* d)
{
    const real q = stretched_slope2(d, p->alpha_x, p->alpha_y);
    const real p_i = stretched_sin2_i(d, p->alpha_x, p->alpha_y);
    const real p_o = stretched_sin2_o(d, p->alpha_x, p->alpha_y);
    const int separable = p->masking == torrance_sparrow_masking_separable;
    if (p->ndf == torrance_sparrow_ndf_ggx)
        return ggx_distribution(d, q, p->alpha_x, p->alpha_y) *
               (separable ? ggx_masking(p_i, d->cos_i) * ggx_masking(p_o, d->cos_o)
                          : ggx_correlated_visibility(p_i, p_o, d->cos_i, d->cos_o));
    return beckmann_distribution(d, q, p->alpha_x, p->alpha_y) *
           (separable ? beckmann_masking(p_i, d->cos_i) * beckmann_masking(p_o, d->cos_o)
                      : beckmann_correlated_visibility(p_i, p_o, d->cos_i, d->cos_o));
}

/// D cos^2 theta_h, and the rest of V-shaped grooves.
static inline real torrance_sparrow_v_cavity(const torrance_sparrow_params* p, const directions* d)
{
    const real q = stretched_slope2(d, p->alpha_x, p->alpha_y);
    const float norm = R(1.0) / (PI * p->alpha_x * p->alpha_y);
    const real inverse = R(1.0) / (R(1.0) + q);
    const real distribution = p->ndf == torrance_sparrow_ndf_ggx
                                  ? norm * (d->sec2_h * inverse) * inverse
                                  : norm * exp_of_negative(q) * d->sec2_h;
    return distribution * v_cavity_visibility(d);
}

static inline void torrance_sparrow_eval(const torrance_sparrow_params* p, const directions* d,
                                         real f[CHANNELS])
{
    const real lobe = p->masking == torrance_sparrow_masking_v_cavity
                          ? torrance_sparrow_v_cavity(p, d)
                          : torrance_sparrow_smith(p, d);
    const incidence at = on_facet(d);
    FOR_CHANNELS(c) f[c] = lobe * FACET_REFLECTANCE(torrance_sparrow, p, c, at);
}

/// The normals that the light sees, D G1 (l.h)/cos_i, over 4 (l.h).
static inline real torrance_sparrow_pdf(const torrance_sparrow_params* p, const directions* d)
{
    const int is_ggx = p->ndf == torrance_sparrow_ndf_ggx;
    const real q = stretched_slope2(d, p->alpha_x, p->alpha_y);
    const real distribution = is_ggx ? ggx_distribution(d, q, p->alpha_x, p->alpha_y)
                                     : beckmann_distribution(d, q, p->alpha_x, p->alpha_y);
    if (p->masking == torrance_sparrow_masking_v_cavity)
        return distribution * v_cavity_visible_part(d);
    const real p_i = stretched_sin2_i(d, p->alpha_x, p->alpha_y);
    return R(0.5) * distribution *
           (is_ggx ? ggx_masking(p_i, d->cos_i) : beckmann_masking(p_i, d->cos_i));
}

static inline mirror_offset torrance_sparrow_sample(const torrance_sparrow_params* p,
                                                    const fixed_light* l, stream* random)
{
    const float x = p->alpha_x, y = p->alpha_y;
    const int is_ggx = p->ndf == torrance_sparrow_ndf_ggx;
    if (p->masking == torrance_sparrow_masking_v_cavity) {
        const half_vector h = is_ggx ? ggx_normal(x, y, random) : beckmann_normal(x, y, random);
        return reflected(l, side_of_groove(l, h, random));
    }
    return reflected(
        l, is_ggx ? ggx_visible_normal(l, x, y, random) : beckmann_visible_normal(l, x, y, random));
}
