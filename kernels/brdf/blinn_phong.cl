// SPDX-License-Identifier: Apache-2.0
// Blinn, SIGGRAPH 1977: (n.h)^n, scaled so that the directional albedo at normal incidence is rho_s
// exactly: (n + 2)(n + 4) / (8 pi (n + 2^(-n/2))).
#include "core/lobe.cl"

static inline void blinn_phong_eval(const blinn_phong_params* p, const directions* d,
                                    real f[CHANNELS])
{
    const float n = p->exponent;
    const real two_to_minus_half_n = exp_of_negative((real)(n * R(0.34657359027997265)));
    const real norm = (n + R(2.0)) * (n + R(4.0)) / (R(8.0) * PI * (n + two_to_minus_half_n));
    // (n.h)^2 = 1 / (1 + tan^2)
    const real lobe = norm * exp_of_negative(R(0.5) * n * log_of_one_plus(d->tan2_h));
    FOR_CHANNELS(c) f[c] = p->rho_s[c] * lobe;
}
