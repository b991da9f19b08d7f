// SPDX-License-Identifier: Apache-2.0
// He, Torrance, Sillion & Greenberg, SIGGRAPH 1991: the directional-diffuse part, eqs. 76 to 79,
// for unpolarised light.
#include "core/lobe.cl"
#include "core/wave.cl"

/// What one direction sees of the surface.
typedef struct {
    real shadowing;  ///< eqs. 24 and 25
    real hidden;     ///< eqs. 82 and 83: tan(theta) erfc(tau cot(theta)/(2 sigma))
} he_torrance_view;

/// slope: 2 sigma/tau. With a = cot(theta)/slope shadowing is (1 - erfc(a)/2)/(1 + Lambda),
/// Lambda = (e^(-a^2)/(a sqrt(pi)) - erfc(a))/2.
static inline he_torrance_view he_torrance_seen(float slope, real cosine, real sine)
{
    // At normal incidence, and for a smooth surface, erfc is 0: the bounds keep 0/0 away.
    const real a = min(cosine / max(slope * sine, (real)(R(1e-30))), (real)(R(12.0)));
    const real gauss = exp_of_negative(a * a);
    const real complement = gauss * scaled_erfc(a);
    const real a_lambda =
        R(0.5) * max(R(0.56418958354775629) * gauss - a * complement, (real)(R(0.0)));
    const he_torrance_view seen = {a * (R(1.0) - R(0.5) * complement) / (a + a_lambda),
                                   complement * sine / cosine};
    return seen;
}

/// Lambert's W: y with y e^y = z for z >= 0, by Newton's method for y + log y = log z.
static inline real he_torrance_lambert_w(real z)
{
    const real bounded = max(z, (real)(R(1e-30)));
    real y = log_of_one_plus(bounded);
    for (int k = 0; k < 3; ++k) y *= (R(1.0) + log_of_positive(bounded / y)) / (R(1.0) + y);
    return y;
}

/// F G S(l) S(v) pi (tau/lambda)^2 W(g, b) with G = cos^2 theta_d/(cos^2 theta_h (n.l)(n.v)), and
/// in g the deviation of the heights that are lit and seen: eqs. 80 and 81, sigma/sqrt(1 + x^2)
/// where x^2 e^(x^2) = (K_i + K_o)^2/(8 pi).
static inline void he_torrance_eval(const he_torrance_params* p, const directions* d,
                                    real f[CHANNELS])
{
    const float slope = R(2.0) * p->sigma / p->tau;
    const he_torrance_view in = he_torrance_seen(slope, d->cos_i, d->sin_i);
    const he_torrance_view out = he_torrance_seen(slope, d->cos_o, d->sin_o);
    const real hidden = square(in.hidden + out.hidden) * (R(0.125) / PI);
    const real sigma = p->sigma / sqrt(R(1.0) + he_torrance_lambert_w(hidden));
    const real shadowing = in.shadowing * out.shadowing;

    const real diffuse = diffracted(d, p->wavelength, sigma, p->tau, R(2.0) * d->mean_cos);
    const real lobe =
        diffuse * d->sec2_h * d->cos2_d * (shadowing * (R(1.0) / (d->cos_i * d->cos_o)));
    const incidence at = on_facet(d);
    FOR_CHANNELS(c) f[c] = lobe * FACET_REFLECTANCE(he_torrance, p, c, at);
}
