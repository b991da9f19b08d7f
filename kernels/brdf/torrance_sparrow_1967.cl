// SPDX-License-Identifier: Apache-2.0
// Torrance & Sparrow, JOSA 57, 1967: F G P/(4 (n.l)(n.v)), P = b exp(-(delta/width)^2) Gaussian in
// the angle between n and h, b = 1/(pi width^2), with G of V-shaped grooves.
#include "core/lobe.cl"

/// theta_h^2, from sin^2 and cos^2: of the smaller one, x, the angle is sqrt(x) Q(x), Q to 3e-8
/// relative.
static inline real squared_angle(real sin2, real cos2)
{
    const real x = min(sin2, cos2), z = x * x;
    const real q0 = fma((real)(R(0.166670203560)), x, (real)(R(0.999999985438)));
    const real q2 = fma((real)(R(0.0467416397477)), x, (real)(R(0.0748597330571)));
    const real q4 = fma((real)(R(0.0800102978784)), x, (real)(R(0.0152228248306)));
    const real q6 = fma((real)(R(0.113449961081)), x, (real)(R(-0.0966453291413)));
    const real q = fma(z * z, fma(q6, z, q4), fma(q2, z, q0));
    const real angle = sqrt(x) * q;
    return square(choose(less(sin2, cos2), angle, R(0.5) * PI - angle));
}

static inline void torrance_sparrow_1967_eval(const torrance_sparrow_1967_params* p,
                                              const directions* d, real f[CHANNELS])
{
    const real cos2 = square(d->mean_cos) / d->cos2_d;
    const float sharpness = R(1.0) / (p->width * p->width);
    const real angle2 = squared_angle(d->tan2_h * cos2, cos2);
    const real lobe = (sharpness / PI) * two_to(-(sharpness * R(1.44269504)) * angle2) *
                      (v_cavity_visibility(d) * cos2);
    const incidence at = on_facet(d);
    FOR_CHANNELS(c) f[c] = lobe * FACET_REFLECTANCE(torrance_sparrow_1967, p, c, at);
}
