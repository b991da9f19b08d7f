// SPDX-License-Identifier: Apache-2.0
// Torrance & Sparrow, JOSA 57, 1967: F G P/(4 (n.l)(n.v)), P = b exp(-(delta/width)^2) Gaussian in
// the angle between n and h, b = 1/(pi width^2), with G of V-shaped grooves.
#include "core/lobe.cl"

static inline void torrance_sparrow_1967_eval(const torrance_sparrow_1967_params* p,
                                              const directions* d, real f[CHANNELS])
{
    const real delta = angle_of(sqrt(d->tan2_h), (real)(R(1.0)));
    const float sharpness = R(1.0) / (p->width * p->width);
    const real lobe = (sharpness / PI) * exp_of_negative(sharpness * square(delta)) *
                      (v_cavity_visibility(d) / d->sec2_h);
    const incidence at = on_facet(d);
    FOR_CHANNELS(c) f[c] = lobe * FACET_REFLECTANCE(torrance_sparrow_1967, p, c, at);
}
