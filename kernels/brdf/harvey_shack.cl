// SPDX-License-Identifier: Apache-2.0
// Krywonos, Harvey & Choi, JOSA A 28(6), 2011, and its forerunners: Q pi (tau/lambda)^2 W(g, b),
// Q = sqrt(F(theta_i) F(theta_o)).
#include "core/lobe.cl"
#include "core/wave.cl"

static inline real harvey_shack_cosines(int form, const directions* d)
{
    if (form == harvey_shack_form_modified) return R(2.0) * d->cos_i;
    return form == harvey_shack_form_original ? (real)(R(2.0)) : R(2.0) * d->mean_cos;
}

static inline void harvey_shack_eval(const harvey_shack_params* p, const directions* d,
                                     real f[CHANNELS])
{
    const real lobe =
        diffracted(d, p->wavelength, (real)(p->sigma), p->tau, harvey_shack_cosines(p->form, d));
    const incidence in = on_surface(d->cos_i, d->cos_i_lo, d->sin_i);
    const incidence out = on_surface(d->cos_o, d->cos_o_lo, d->sin_o);
    FOR_CHANNELS(c)
    f[c] = lobe * sqrt(FACET_REFLECTANCE(harvey_shack, p, c, in) *
                       FACET_REFLECTANCE(harvey_shack, p, c, out));
}
