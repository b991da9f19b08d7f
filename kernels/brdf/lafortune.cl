// SPDX-License-Identifier: Apache-2.0
// Lafortune, Foo, Torrance & Greenberg, SIGGRAPH 1997: one lobe
// (c_x l.x v.x + c_y l.y v.y + c_z l.z v.z)^n, 0 where the sum is not positive.
#include "core/lobe.cl"

/// In two floats: the sum cancels, and exponents of hundreds magnify what rounding leaves.
static inline two_floats lafortune_sum(const lafortune_params* p, const directions* d, int c)
{
    const two_floats along = two_floats_times(p->c_z[c], d->cos_cos);
#if ISOTROPIC
    return two_floats_gathered(two_floats_times(p->c_x[c], d->tangent), along);
#else
    const two_floats x = two_floats_times(p->c_x[c], d->x_x);
    const two_floats y = two_floats_times(p->c_y[c], d->y_y);
    return two_floats_gathered(two_floats_gathered(x, y), along);
#endif
}

static inline void lafortune_eval(const lafortune_params* p, const directions* d, real f[CHANNELS])
{
    FOR_CHANNELS(c)
    {
        const two_floats sum = lafortune_sum(p, d, c);
        const real power = power_of_parts(parts_of_sum(sum.hi, sum.lo), (real)(p->exponent[c]));
        f[c] = choose(less((real)(R(0.0)), sum.hi + sum.lo), power, (real)(R(0.0)));
    }
}
