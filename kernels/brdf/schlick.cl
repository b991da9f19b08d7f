// SPDX-License-Identifier: Apache-2.0
// Schlick, Graphics Gems IV, 1994: the value t / (n - n t + t) in place of Phong's t^n, t = r.v.
#include "core/lobe.cl"

static inline void schlick_eval(const schlick_params* p, const directions* d, real f[CHANNELS])
{
    // n - n t + t = n (1 - t) + t, both exact where they are small
    const real rational = d->cos_r / (p->exponent * d->mirror + d->cos_r);
    const real lobe = choose(less((real)(R(0.0)), d->cos_r), rational, (real)(R(0.0)));
    FOR_CHANNELS(c) f[c] = p->k_s[c] * lobe;
}
