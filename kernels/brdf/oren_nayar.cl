// SPDX-License-Identifier: Apache-2.0
// Oren & Nayar, SIGGRAPH 1994, the qualitative model (eq. 30): rho/pi (A + B max(0, cos phi) sin
// alpha tan beta). With s the tangential part of l.v, max(0, cos phi) sin alpha tan beta is max(0,
// s) / max(cos_i, cos_o).
#include "core/lobe.cl"

static inline void oren_nayar_eval(const oren_nayar_params* p, const directions* d,
                                   real f[CHANNELS])
{
    const float sigma2 = p->sigma * p->sigma;
    const float a = R(1.0) - R(0.5) * sigma2 / (sigma2 + R(0.33));
    const float b = R(0.45) * sigma2 / (sigma2 + R(0.09));
    const real scale = b / max(d->cos_i, d->cos_o);
    const real lobe = (a + scale * max(d->azimuth, (real)(R(0.0)))) * (R(1.0) / PI);
    FOR_CHANNELS(c) f[c] = p->rho[c] * lobe;
}
