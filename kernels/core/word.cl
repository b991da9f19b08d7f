// SPDX-License-Identifier: Apache-2.0
// Whole numbers of the vector width, for random numbers and for what must add up exactly.
#ifndef GONIO_CORE_WORD
#define GONIO_CORE_WORD
#include "core/real.cl"

#if WIDTH == 1
typedef uint word;
typedef ulong long_word;
#define EQUAL(a, b) (-(int)((a) == (b)))
#define SMALLER(a, b) (-(int)((a) < (b)))
#define as_words as_uint
#define word_of convert_uint
#define long_of convert_ulong
static inline word choose_word(mask_t mask, word yes, word no)
{
    return mask ? yes : no;
}
static inline word load_words(const uint* from)
{
    return *from;
}
static inline void store_words(word value, uint* to)
{
    *to = value;
}
/// Of all lanes.
static inline ulong sum_of(word value)
{
    return value;
}
#else
typedef JOIN(uint, WIDTH) word;
typedef JOIN(ulong, WIDTH) long_word;
#define EQUAL(a, b) ((a) == (b))
#define SMALLER(a, b) ((a) < (b))
#define as_words JOIN(as_uint, WIDTH)
#define word_of JOIN(convert_uint, WIDTH)
#define long_of JOIN(convert_ulong, WIDTH)
static inline word choose_word(mask_t mask, word yes, word no)
{
    return select(no, yes, mask);
}
static inline word load_words(const uint* from)
{
    return JOIN(vload, WIDTH)(0, from);
}
static inline void store_words(word value, uint* to)
{
    JOIN(vstore, WIDTH)(value, 0, to);
}
static inline ulong sum_of(word value)
{
#if WIDTH == 2
    const ulong2 two = convert_ulong2(value);
#elif WIDTH == 4
    const ulong2 two = convert_ulong2(value.lo) + convert_ulong2(value.hi);
#else
#if WIDTH == 8
    const ulong4 four = convert_ulong4(value.lo) + convert_ulong4(value.hi);
#else
    const ulong8 eight = convert_ulong8(value.lo) + convert_ulong8(value.hi);
    const ulong4 four = eight.lo + eight.hi;
#endif
    const ulong2 two = four.lo + four.hi;
#endif
    return two.x + two.y;
}
#endif
static inline mask_t equal(mask_t a, mask_t b)
{
    return EQUAL(a, b);
}
static inline mask_t smaller(word a, word b)
{
    return SMALLER(a, b);
}

static inline mask_t choose_count(mask_t mask, mask_t yes, mask_t no)
{
    return (mask & yes) | (not_(mask) & no);
}

#endif
