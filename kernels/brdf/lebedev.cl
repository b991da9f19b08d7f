// SPDX-License-Identifier: Apache-2.0
// An analytic lobe and a grid, after Ilyin, Lebedev, Sinyavsky & Ignatenko, GraphiCon 2009:
// (k_d/pi + k_s D G2/(4 cos_i cos_o)) exp R. A reconstruction: see the registry.
#include "core/lobe.cl"
#include "core/residual.cl"

static inline void lebedev_eval(const lebedev_params* p, const directions* d, real f[CHANNELS])
{
    const float alpha2 = p->alpha * p->alpha;
    const real lobe = ggx_distribution(d, d->tan2_h * (R(1.0) / alpha2), p->alpha, p->alpha) *
                      ggx_correlated_visibility(square(d->sin_i) * alpha2,
                                                square(d->sin_o) * alpha2, d->cos_i, d->cos_o);
    const residual_place place = residual_place_of(p->residual, d);
    FOR_CHANNELS(c)
    {
        const real analytic = p->k_d[c] * (R(1.0) / PI) + p->k_s[c] * lobe;
        f[c] = analytic * exp_of_negative(-residual_at(&place, c));
    }
}
