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
