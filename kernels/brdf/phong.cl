// SPDX-License-Identifier: Apache-2.0
// Phong, CACM 18(6), 1975: (r.v)^n, normalised as in Lafortune & Willems, Report CW 197, KU Leuven,
// 1994: (n + 2)/(2 pi).
#include "core/lobe.cl"

static inline void phong_eval(const phong_params* p, const directions* d, real f[CHANNELS])
{
    const float norm = p->form == phong_form_normalised
                           ? (p->exponent + R(2.0)) * (R(1.0) / (R(2.0) * PI))
                           : R(1.0);
    const real lobe = norm * power_of_cos_r(d, p->exponent);
    FOR_CHANNELS(c) f[c] = p->rho_s[c] * lobe;
}

/// (n + 1)/(2 pi) (r.v)^n, of which a part lies below the horizon: Lafortune & Willems 1994.
static inline real phong_pdf(const phong_params* p, const directions* d)
{
    const float norm = (p->exponent + R(1.0)) * (R(1.0) / (R(2.0) * PI));
    return norm * power_of_cos_r(d, p->exponent);
}

static inline mirror_offset phong_sample(const phong_params* p, const fixed_light* l,
                                         stream* random)
{
    const real u = uniform_of(next_word(random));
    return about_mirror(l, one_less_root(u, (real)(p->exponent + R(1.0))),
                        even_azimuth(next_word(random)));
}
