// SPDX-License-Identifier: Apache-2.0
// Torrance & Sparrow, JOSA 57, 1967, in the form of Walter et al., EGSR 2007, eq. 20: F D G2 / (4
// cos_i cos_o), anisotropic, with height-correlated Smith masking (Heitz, JCGT 3(2), 2014).
#include "core/lobe.cl"

static inline void torrance_sparrow_eval(const torrance_sparrow_params* p, const directions* d,
                                         real f[CHANNELS])
{
    const real q = stretched_slope2(d, p->alpha_x, p->alpha_y);
    const real p_i = stretched_sin2_i(d, p->alpha_x, p->alpha_y);
    const real p_o = stretched_sin2_o(d, p->alpha_x, p->alpha_y);
    const real lobe = p->ndf == torrance_sparrow_ndf_ggx
                          ? ggx_distribution(d, q, p->alpha_x, p->alpha_y) *
                                ggx_visibility(p_i, p_o, d->cos_i, d->cos_o)
                          : beckmann_distribution(d, q, p->alpha_x, p->alpha_y) *
                                beckmann_visibility(p_i, p_o, d->cos_i, d->cos_o);
    const real cos_d = sqrt(d->cos2_d);
    FOR_CHANNELS(c) f[c] = lobe * FACET_REFLECTANCE(torrance_sparrow, p, c, cos_d);
}
