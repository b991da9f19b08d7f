// SPDX-License-Identifier: Apache-2.0
// Cook & Torrance, ACM TOG 1(1), 1982: Beckmann facets in V-shaped grooves, with the factor 1/4
// that normalises it (Walter et al., EGSR 2007, eq. 20) in place of the paper's 1/pi.
#include "core/lobe.cl"

static inline void cook_torrance_eval(const cook_torrance_params* p, const directions* d,
                                      real f[CHANNELS])
{
    const real q = d->tan2_h * (R(1.0) / (p->m * p->m));
    const real lobe = beckmann_distribution(d, q, p->m, p->m) * v_cavity_visibility(d);
    const real cos_d = sqrt(d->cos2_d);
    FOR_CHANNELS(c) f[c] = lobe * FACET_REFLECTANCE(cook_torrance, p, c, cos_d);
}
