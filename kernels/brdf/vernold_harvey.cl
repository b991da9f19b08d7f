// SPDX-License-Identifier: Apache-2.0
// Vernold & Harvey, Proc. SPIE 3426, 1998: F pi (tau/lambda)^2 W(g, b).
#include "core/lobe.cl"
#include "core/wave.cl"

static inline void vernold_harvey_eval(const vernold_harvey_params* p, const directions* d,
                                       real f[CHANNELS])
{
    const real lobe = diffracted(d, p->wavelength, (real)(p->sigma), p->tau, R(2.0) * d->mean_cos);
    const incidence at = on_facet(d);
    FOR_CHANNELS(c) f[c] = lobe * FACET_REFLECTANCE(vernold_harvey, p, c, at);
}
