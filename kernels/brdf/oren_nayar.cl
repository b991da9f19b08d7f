// SPDX-License-Identifier: Apache-2.0
// Oren & Nayar, SIGGRAPH 1994, and the forms without angles that follow it.
#include "core/lobe.cl"

/// What multiplies rho/pi, and what multiplies rho^2/pi.
typedef struct {
    real once, twice;
} oren_nayar_terms;

/// Oren & Nayar 1994, eq. 30: A + B max(0, cos phi) sin alpha tan beta, which is
/// A + B max(0, s)/max(cos_i, cos_o) with s the tangential part of l.v.
static inline oren_nayar_terms oren_nayar_qualitative(float sigma2, const directions* d)
{
    const float a = R(1.0) - R(0.5) * sigma2 / (sigma2 + R(0.33));
    const float b = R(0.45) * sigma2 / (sigma2 + R(0.09));
    const real scale = b / max(d->cos_i, d->cos_o);
    const oren_nayar_terms f = {a + scale * max(d->tangent.hi, (real)(R(0.0))), (real)(R(0.0))};
    return f;
}

/// Oren & Nayar 1994, all terms: C1 + cos phi C2 tan beta + (1 - |cos phi|) C3 tan((alpha +
/// beta)/2) of direct light, and light reflected twice. alpha, beta: the greater and the lesser
/// angle.
static inline oren_nayar_terms oren_nayar_full(float sigma2, const directions* d)
{
    const float rough = sigma2 / (sigma2 + R(0.09));
    const real cos_alpha = min(d->cos_i, d->cos_o), sin_alpha = max(d->sin_i, d->sin_o);
    const real cos_beta = max(d->cos_i, d->cos_o), sin_beta = min(d->sin_i, d->sin_o);
    const real alpha = angle_of(sin_alpha, cos_alpha), beta = angle_of(sin_beta, cos_beta);
    const real part = (R(2.0) / PI) * beta;
    const real rest = (R(2.0) / PI) * angle_of(cos_beta, sin_beta);
    const mask_t behind = less(d->cos_phi, (real)(R(0.0)));
    // sin alpha - part^3 = (1 - part^3) - (1 - sin alpha)
    const real lowered =
        rest * (R(1.0) + part + square(part)) - square(cos_alpha) / (R(1.0) + sin_alpha);
    const real tan_beta = R(0.45) * rough * (sin_beta / cos_beta);
    const real c3 = R(0.125) * rough * square((R(4.0) / (PI * PI)) * alpha * beta);
    const real tan_mean = c3 * (d->sin_i + d->sin_o) / (R(2.0) * d->mean_cos);
    const oren_nayar_terms f = {
        (R(1.0) - R(0.5) * sigma2 / (sigma2 + R(0.33))) +
            d->cos_phi * choose(behind, tan_beta * lowered, tan_beta * sin_alpha) +
            d->out_of_plane * tan_mean,
        R(0.17) * sigma2 / (sigma2 + R(0.13)) * (R(1.0) - d->cos_phi * square(part))};
    return f;
}

#define OREN_NAYAR_HALF_MINUS (R(0.5) - R(2.0) / (R(3.0) * PI))

/// Portsmouth, Kutz & Hill, JCGT 2025: A + B s/t with B = r A and t = max(cos_i, cos_o) where s >
/// 0, else 1. There 1 + r s = (1 - r) + r (1 + s), and 1 + s = (1 - r.v) + cos_i cos_o.
static inline real oren_nayar_fujii(float r, const directions* d)
{
    const float a = R(1.0) / (R(1.0) + OREN_NAYAR_HALF_MINUS * r);
    const real before = a + (a * r) / max(d->cos_i, d->cos_o) * d->tangent.hi;
    const real behind = a * (R(1.0) - r) + (a * r) * (d->mirror + d->cos_cos.hi);
    return choose(less((real)(R(0.0)), d->tangent.hi), before, behind);
}

/// (1 - E)/(A r) with E the albedo of fujii for rho = 1, in the complement of theta, so that it
/// vanishes at grazing as it should.
static inline real oren_nayar_missing(real cosine, real sine)
{
    const real complement = angle_of(cosine, sine);
    const real lost = square(cosine) / (R(1.0) + sine);
    const real turn =
        R(0.66666666666666667) * sine * cosine * (R(1.0) + sine + square(sine)) / (R(1.0) + sine);
    const real pi_times = (R(0.5) * PI - R(0.66666666666666667)) * lost +
                          (sine * complement + square(sine) * cosine - turn);
    return pi_times * (R(1.0) / PI);
}

static inline void oren_nayar_eval(const oren_nayar_params* p, const directions* d,
                                   real f[CHANNELS])
{
    const float sigma2 = p->sigma * p->sigma, r = p->roughness;
    if (p->form == oren_nayar_form_qualitative || p->form == oren_nayar_form_full) {
        const oren_nayar_terms terms = p->form == oren_nayar_form_full
                                           ? oren_nayar_full(sigma2, d)
                                           : oren_nayar_qualitative(sigma2, d);
        FOR_CHANNELS(c)
        {
            const float rho = p->rho[c];
            f[c] = (rho / PI) * max(terms.once + rho * terms.twice, (real)(R(0.0)));
        }
        return;
    }
    const real once = oren_nayar_fujii(r, d);
    // fujii plus rho_ms/pi (1 - E_i)(1 - E_o)/(1 - E_mean), E_mean = A (1 + (2/3 - 28/(15 pi)) r)
    const float mean_rise = R(0.66666666666666667) - R(28.0) / (R(15.0) * PI);
    const float a = R(1.0) / (R(1.0) + OREN_NAYAR_HALF_MINUS * r);
    const float mean = a * (R(1.0) + mean_rise * r);
    const real missing = oren_nayar_missing(d->cos_i, d->sin_i) *
                         oren_nayar_missing(d->cos_o, d->sin_o) *
                         (a * r / (OREN_NAYAR_HALF_MINUS - mean_rise));
    FOR_CHANNELS(c)
    {
        const float rho = p->rho[c];
        const float rho_ms = rho * rho * mean / (R(1.0) - rho * (R(1.0) - mean));
        f[c] = rho / PI * once;
        if (p->form == oren_nayar_form_eon) f[c] += rho_ms / PI * missing;
    }
}
