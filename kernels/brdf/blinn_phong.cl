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
    const real norm = blinn_phong_norm(p->form, p->exponent);
    const real power = power_of_cos_h(d, (real)(p->exponent));
    FOR_CHANNELS(c) f[c] = p->rho_s[c] * norm * power;
}

/// Half vectors with (n + 1)/(2 pi) (n.h)^n, over 4 (l.h).
static inline real blinn_phong_pdf(const blinn_phong_params* p, const directions* d)
{
    const float norm = (p->exponent + R(1.0)) * (R(1.0) / (R(8.0) * PI));
    return norm * power_of_cos_h(d, (real)(p->exponent)) / sqrt(d->cos2_d);
}

static inline mirror_offset blinn_phong_sample(const blinn_phong_params* p, const fixed_light* l,
                                               stream* random)
{
    const real u = uniform_of(next_word(random));
    const real slope = sqrt(tan2_of_root(u, (real)(p->exponent + R(1.0))));
    return reflected(l, stretched_normal(slope, even_azimuth(next_word(random)), R(1.0), R(1.0)));
}
