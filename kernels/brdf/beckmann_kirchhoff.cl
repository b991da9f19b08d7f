// SPDX-License-Identifier: Apache-2.0
// Beckmann & Spizzichino, The scattering of electromagnetic waves from rough surfaces, 1963, 5.3:
// F cos^2 theta_d/(cos^2 theta_h (n.l)(n.v)) pi (tau/lambda)^2 W(g, b).
#include "core/lobe.cl"
#include "core/wave.cl"

static inline void beckmann_kirchhoff_eval(const beckmann_kirchhoff_params* p, const directions* d,
                                           real f[CHANNELS])
{
    const real diffuse =
        diffracted(d, p->wavelength, (real)(p->sigma), p->tau, R(2.0) * d->mean_cos);
    // At grazing sec^2 is large and W small: their product first.
    const real lobe = diffuse * d->sec2_h * d->cos2_d * (R(1.0) / (d->cos_i * d->cos_o));
    const incidence at = on_facet(d);
    FOR_CHANNELS(c) f[c] = lobe * FACET_REFLECTANCE(beckmann_kirchhoff, p, c, at);
}
