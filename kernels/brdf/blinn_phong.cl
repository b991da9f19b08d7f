// SPDX-License-Identifier: Apache-2.0
// Blinn, SIGGRAPH 1977: (n.h)^n. Of its factors the exact one makes the directional albedo at
// normal incidence rho_s: (n + 2)(n + 4)/(8 pi (n + 2^(-n/2))).
#include "core/lobe.cl"

static inline real blinn_phong_norm(int form, float n)
{
    const float eighth = R(1.0) / (R(8.0) * PI);
    if (form == blinn_phong_form_blinn_1977) return (real)(R(1.0));
    if (form == blinn_phong_form_norm8) return (real)((n + R(8.0)) * eighth);
    const real two_to_minus_half_n = exp_of_negative((real)(n * R(0.34657359027997265)));
    return (n + R(2.0)) * (n + R(4.0)) * eighth / (n + two_to_minus_half_n);
}

static inline void blinn_phong_eval(const blinn_phong_params* p, const directions* d,
                                    real f[CHANNELS])
{
    const real lobe = blinn_phong_norm(p->form, p->exponent) * power_of_cos_h(d, p->exponent);
    FOR_CHANNELS(c) f[c] = p->rho_s[c] * lobe;
}
