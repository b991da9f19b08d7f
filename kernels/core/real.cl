// SPDX-License-Identifier: Apache-2.0
// The width-generic number `real` (float at width 1, floatN else) and its masks. A comparison in
// OpenCL C is 1 for scalars and -1 for vectors; here a mask has all bits set at every width.
#ifndef GONIO_CORE_REAL
#define GONIO_CORE_REAL

#pragma OPENCL FP_CONTRACT OFF

#ifndef WIDTH
#define WIDTH 1
#endif

#define JOIN_TOKENS(a, b) a##b
#define JOIN(a, b) JOIN_TOKENS(a, b)

/// A literal of the kernels' precision: R(0.5).
#define R(literal) JOIN(literal, f)
#define PI R(3.14159265358979323846)

#if WIDTH == 1
typedef float real;
typedef int mask_t;  ///< also the integer of the same width
#define LESS(a, b) (-(int)((a) < (b)))
#define bits_of as_int
#define as_real as_float
#define real_of convert_float
#define int_of convert_int
static inline real choose(mask_t mask, real yes, real no)
{
    return mask ? yes : no;
}
static inline real load(global const float* from)
{
    return *from;
}
static inline void store(real value, global float* to)
{
    *to = value;
}
static inline real reversed(real value)
{
    return value;
}
/// Not any(), of which PoCL makes a branch for each lane.
static inline int any_of(mask_t mask)
{
    return mask != 0;
}
static inline real gather(global const float* from, mask_t index)
{
    return from[index];
}
#else
typedef JOIN(float, WIDTH) real;
typedef JOIN(int, WIDTH) mask_t;
#define LESS(a, b) ((a) < (b))
#define bits_of JOIN(as_int, WIDTH)
#define as_real JOIN(as_float, WIDTH)
#define real_of JOIN(convert_float, WIDTH)
#define int_of JOIN(convert_int, WIDTH)
static inline real choose(mask_t mask, real yes, real no)
{
    return select(no, yes, mask);
}
static inline real load(global const float* from)
{
    return JOIN(vload, WIDTH)(0, from);
}
static inline void store(real value, global float* to)
{
    JOIN(vstore, WIDTH)(value, 0, to);
}
/// from[index], lane by lane
static inline real gather(global const float* from, mask_t index)
{
    int at[WIDTH];
    float values[WIDTH];
    JOIN(vstore, WIDTH)(index, 0, at);
    for (int k = 0; k < WIDTH; ++k) values[k] = from[at[k]];
    return JOIN(vload, WIDTH)(0, values);
}
#if WIDTH == 2
static inline real reversed(real value)
{
    return value.s10;
}
static inline int any_of(mask_t mask)
{
    return (mask.x | mask.y) != 0;
}
#elif WIDTH == 4
static inline real reversed(real value)
{
    return value.s3210;
}
static inline int any_of(mask_t mask)
{
    const ulong2 pairs = as_ulong2(mask);
    return (pairs.x | pairs.y) != 0;
}
#elif WIDTH == 8
static inline real reversed(real value)
{
    return value.s76543210;
}
static inline int any_of(mask_t mask)
{
    const ulong2 folded = as_ulong4(mask).lo | as_ulong4(mask).hi;
    return (folded.x | folded.y) != 0;
}
#else
static inline real reversed(real value)
{
    return value.sfedcba9876543210;
}
static inline int any_of(mask_t mask)
{
    const ulong4 folded = as_ulong8(mask).lo | as_ulong8(mask).hi;
    const ulong2 pairs = folded.lo | folded.hi;
    return (pairs.x | pairs.y) != 0;
}
#endif
#endif

static inline mask_t less(real a, real b)
{
    return LESS(a, b);
}
static inline mask_t not_(mask_t mask)
{
    return ~mask;
}
static inline real square(real x)
{
    return x * x;
}

/// x^5
static inline real fifth_power(real x)
{
    return x * square(square(x));
}

/// One number in two floats, |lo| at most half an ulp of hi.
typedef struct {
    real hi, lo;
} two_floats;

/// a b, to about 2^-46 relative.
static inline two_floats two_floats_product(two_floats a, two_floats b)
{
    const real product = a.hi * b.hi;
    const two_floats result = {product, fma(a.hi, b.hi, -product) + (a.hi * b.lo + a.lo * b.hi)};
    return result;
}

static inline two_floats two_floats_times(float a, two_floats b)
{
    const real product = a * b.hi;
    const two_floats result = {product, fma((real)(a), b.hi, -product) + a * b.lo};
    return result;
}

/// a + b, to about 2^-46 of the larger one (the exact sum of the high parts: Knuth, The Art of
/// Computer Programming 2, 4.2.2, theorem B). Where the high parts cancel the low one may be as
/// large as what is left of them.
static inline two_floats two_floats_gathered(two_floats a, two_floats b)
{
    const real sum = a.hi + b.hi;
    const real part = sum - a.hi;
    const real lost = (a.hi - (sum - part)) + (b.hi - part);
    const two_floats result = {sum, lost + (a.lo + b.lo)};
    return result;
}

/// The same with a low part that is what the high one rounds away.
static inline two_floats two_floats_plus(two_floats a, two_floats b)
{
    const two_floats sum = two_floats_gathered(a, b);
    const real high = sum.hi + sum.lo;
    const two_floats result = {high, sum.lo - (high - sum.hi)};
    return result;
}

static inline two_floats two_floats_minus(two_floats a, two_floats b)
{
    const two_floats negative = {-b.hi, -b.lo};
    return two_floats_plus(a, negative);
}

/// a - b c, to about an ulp: where the difference cancels, the fused one of the high parts is exact
/// but for its own rounding.
static inline real two_floats_less_product(two_floats a, two_floats b, two_floats c)
{
    return fma(-b.hi, c.hi, a.hi) + fma(-b.hi, c.lo, fma(-b.lo, c.hi, a.lo));
}

/// a + b, to about an ulp. Where the sum cancels, a.hi + b.hi is exact (Sterbenz 1974) and the low
/// parts give the digits; where it does not, the low parts do not matter.
static inline real two_floats_sum(two_floats a, two_floats b)
{
    return (a.hi + b.hi) + (a.lo + b.lo);
}

/// a - b, likewise.
static inline real two_floats_difference(two_floats a, two_floats b)
{
    return (a.hi - b.hi) + (a.lo - b.lo);
}

#endif
