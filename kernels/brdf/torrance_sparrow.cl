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
