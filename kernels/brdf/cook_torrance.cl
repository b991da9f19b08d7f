// SPDX-License-Identifier: Apache-2.0
// Cook & Torrance, ACM TOG 1(1), 1982: Beckmann facets in V-shaped grooves, and its misprints.
#include "core/lobe.cl"

/// exp(-(tan/m)^2); the print has lost the square of the tangent.
static inline real cook_torrance_exponential(const cook_torrance_params* p, const directions* d)
{
    const float sharpness = R(1.0) / (p->m * p->m);
    return exp_of_negative(
        sharpness * (p->form == cook_torrance_form_as_printed ? sqrt(d->tan2_h) : d->tan2_h));
}

/// sec^2 theta_h G/(4 cos_i cos_o); with the misprint G = min(1, 2 cos_i, 2 cos_o).
static inline real cook_torrance_visibility(const cook_torrance_params* p, const directions* d)
{
    if (p->form != cook_torrance_form_as_printed) return v_cavity_visibility(d);
    const real open = R(0.25) / (d->cos_i * d->cos_o);
    return d->sec2_h * min(open, R(0.5) / max(d->cos_i, d->cos_o));
}

/// What multiplies exp(...) G/(4 m^2 cos^4 theta_h cos_i cos_o).
static inline float cook_torrance_factor(int form)
{
    if (form == cook_torrance_form_modern) return R(1.0) / PI;
    return form == cook_torrance_form_cook_torrance_1982 ? R(4.0) / PI : R(1.0);
}

static inline void cook_torrance_eval(const cook_torrance_params* p, const directions* d,
                                      real f[CHANNELS])
{
    const float norm = cook_torrance_factor(p->form) / (p->m * p->m);
    const real lobe =
        norm * cook_torrance_exponential(p, d) * d->sec2_h * cook_torrance_visibility(p, d);
    const incidence at = on_facet(d);
    FOR_CHANNELS(c) f[c] = lobe * FACET_REFLECTANCE(cook_torrance, p, c, at);
}

/// The normals that the light sees in V-shaped grooves, D G1 (l.h)/cos_i, over 4 (l.h). With the
/// misprint D is exp(-tan theta_h/m^2)/(2 pi m^4 cos^4 theta_h), so that it can be normalised.
static inline real cook_torrance_pdf(const cook_torrance_params* p, const directions* d)
{
    const float m2 = p->m * p->m;
    const float norm = p->form == cook_torrance_form_as_printed ? R(1.0) / (R(2.0) * PI * m2 * m2)
                                                                : R(1.0) / (PI * m2);
    const real distribution = norm * cook_torrance_exponential(p, d) * d->sec2_h * d->sec2_h;
    return distribution * v_cavity_visible_part(d);
}

static inline mirror_offset cook_torrance_sample(const cook_torrance_params* p,
                                                 const fixed_light* l, stream* random)
{
    if (p->form != cook_torrance_form_as_printed)
        return reflected(l, side_of_groove(l, beckmann_normal(p->m, p->m, random), random));
    // tan theta_h/m^2 is the sum of two exponential variates.
    const real u = uniform_of(next_word(random)), v = uniform_of(next_word(random));
    const real slope = -(log_of_positive(u) + log_of_positive(v)) * p->m;
    const half_vector h = stretched_normal(slope, even_azimuth(next_word(random)), p->m, p->m);
    return reflected(l, side_of_groove(l, h, random));
}
