// SPDX-License-Identifier: Apache-2.0
// Philox4x32: Salmon et al., Parallel Random Numbers: As Easy as 1, 2, 3, SC 2011. What it gives
// depends on nothing but a counter and a key.
#ifndef GONIO_CORE_PHILOX
#define GONIO_CORE_PHILOX
#include "core/word.cl"

typedef struct {
    word a, b, c, d;
} four_words;

static inline word high_word(word a, uint b)
{
    // Not mul_hi(), which PoCL compiles badly.
    return word_of((long_of(a) * (ulong)b) >> 32);
}

static inline four_words philox(four_words counter, ulong key, int rounds)
{
    four_words s = counter;
    uint key_0 = (uint)key, key_1 = (uint)(key >> 32);
    for (int round = 0; round < rounds; ++round) {
        const word high_0 = high_word(s.a, 0xD2511F53u), low_0 = s.a * 0xD2511F53u;
        const word high_1 = high_word(s.c, 0xCD9E8D57u), low_1 = s.c * 0xCD9E8D57u;
        const four_words next = {high_1 ^ s.b ^ key_0, low_1, high_0 ^ s.d ^ key_1, low_0};
        s = next;
        key_0 += 0x9E3779B9u;
        key_1 += 0xBB67AE85u;
    }
    return s;
}

/// The counter of photon or sample first + offset: (low, high, 0, 0).
static inline four_words numbered(ulong first, word offset)
{
    const word low = (uint)first + offset;
    const word carry = choose_word(smaller(low, offset), (word)(1), (word)(0));
    const four_words counter = {low, (uint)(first >> 32) + carry, (word)(0), (word)(0)};
    return counter;
}

static inline four_words choose_words(mask_t mask, four_words yes, four_words no)
{
    const four_words chosen = {choose_word(mask, yes.a, no.a), choose_word(mask, yes.b, no.b),
                               choose_word(mask, yes.c, no.c), choose_word(mask, yes.d, no.d)};
    return chosen;
}

#endif
