// SPDX-License-Identifier: Apache-2.0
// Diffraction by a rough surface: the series that every wave-optics model of a Gaussian surface
// ends in, W(g, b) = sum over m >= 1 of e^-g g^m/(m! m) e^(-b/m) (Beckmann & Spizzichino
// 1963, 5.3).
#ifndef GONIO_CORE_WAVE
#define GONIO_CORE_WAVE
#include "core/math.cl"
#include "directions/directions.cl"

/// Above this g the series is summed by Laplace's method, whose error is 6e-6 here and falls with
/// g^3; below it, term by term.
#define WAVE_SERIES_LAPLACE R(64.0)

/// W(g, b) for 0 <= g <= 64, term by term: about g + 6 sqrt(g) + 4 terms. A lane that is done adds
/// nothing more, whatever its neighbours need.
static inline real wave_series_sum(real g, real b)
{
    // Where W is above e^-35 the terms rise at most up to here. The first ones may underflow.
    const real reach = R(3.0) + R(7.0) * sqrt(g) + R(0.6) * g;
    real sum = (real)(R(0.0));
    real weight = exp_of_negative(g);
    for (int m = 1; m < 192; ++m) {
        const float inverse = R(1.0) / (float)m;
        weight *= g * inverse;
        const real term = weight * inverse * exp_of_negative(b * inverse);
        sum += term;
        // What is below 2^-25 of the sum no longer changes it.
        const mask_t unfinished = less(sum * R(1e-8), term) | less((real)((float)m), reach);
        if (!any_of(unfinished)) break;
        weight = choose(unfinished, weight, (real)(R(0.0)));
    }
    return sum;
}

/// W(g, b) for g >= 64: Laplace's method for the integral over y = log m with Stirling's m!, about
/// its peak y = log g + u, where g u e^u + 1/2 = (b + 1/12)/m. With S the second derivative there
/// and n = m/S the two corrections are 5 q^2/24 - (1 + 2 n)/8, q = 2 n - 1/(2 S), over S, and a
/// polynomial in n over S^2. The sum differs from the integral by e^(-2 pi^2 S/m^2 ...) only.
static inline real wave_series_integral(real g, real b)
{
    const real per_g = R(1.0) / g;
    const real slope = (b + R(0.083333333333333333)) * per_g;
    const real curved = slope * per_g;
    // 2 u e^(2 u) = 2 (b + 1/12)/g^2 but for the 1/2: within 1.5 % by a rational function, and then
    // one step of Newton's method. Beyond the bound the result underflows.
    const real z = min(R(2.0) * curved, (real)(R(4.5)));
    const real near = R(0.5) * z * (R(1.0) + R(0.121105) * z) / (R(1.0) + R(0.978822) * z);
    const real fall = exp_of_negative(near);
    const real half_per_g = R(0.5) * per_g * fall;
    const real push = curved * square(fall);
    const real u = near - (near + half_per_g - push) / (R(1.0) - half_per_g + R(2.0) * push);

    // e^-g g^m/m! e^(-b/m) at the peak: g (1 + e^u (u - 1)) + b/m as a polynomial, since it
    // cancels.
    real p = (real)(R(0.0016085270326584578));
    p = fma(p, u, (real)(R(0.006612100638449192)));
    p = fma(p, u, (real)(R(0.033449649810791016)));
    p = fma(p, u, (real)(R(0.12498247623443604)));
    p = fma(p, u, (real)(R(0.33333417773246765)));
    p = fma(p, u, (real)(R(0.5)));
    const real shrink = exp_of_negative(u);
    const real m = g / shrink;
    const real pull = slope * shrink;
    const real exponent = g * square(u) * p + pull;

    const real s = m + R(2.0) * pull - R(0.5);
    const real per_s = R(1.0) / s;
    const real n = m * per_s;
    const real q = R(2.0) * n - R(0.5) * per_s;
    const real first = R(0.20833333333333333) * square(q) - R(0.125) * (R(1.0) + R(2.0) * n);
    real second = (real)(R(5.3472222222222222));
    second = fma(second, n, (real)(R(-4.375)));
    second = fma(second, n, (real)(R(-0.65625)));
    second = fma(second, n, (real)(R(0.28125)));
    second = fma(second, n, (real)(R(0.0703125)));
    const real corrections = R(1.0) + per_s * (first + per_s * second);
    return exp_of_negative(exponent) * corrections / sqrt(m * s);
}

/// W(g, b) for g, b >= 0.
static inline real wave_series(real g, real b)
{
    const mask_t rough = less((real)(WAVE_SERIES_LAPLACE), g);
    real w = (real)(R(0.0));
    if (any_of(rough)) w = wave_series_integral(max(g, (real)(WAVE_SERIES_LAPLACE)), b);
    if (any_of(not_(rough)))
        w = choose(rough, w, wave_series_sum(min(g, (real)(WAVE_SERIES_LAPLACE)), b));
    return w;
}

/// pi (tau/lambda)^2 W(g, b): what a surface with heights of deviation sigma and correlation length
/// tau (um) scatters of light of that wavelength (nm), with g = (2 pi sigma/lambda cosines)^2 and
/// b = (pi tau/lambda |l + v|_xy)^2.
static inline real diffracted(const directions* d, float wavelength, real sigma, float tau,
                              real cosines)
{
    const float per_um = R(1000.0) / wavelength;
    const float lengths = tau * per_um;
    const real g = square((R(2.0) * PI * per_um) * sigma * cosines);
    const real b = square((R(2.0) * PI) * lengths * d->mean_cos) * d->tan2_h;
    return (PI * lengths * lengths) * wave_series(g, b);
}

#endif
