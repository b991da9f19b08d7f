// SPDX-License-Identifier: Apache-2.0
// Light transport in layers by Monte Carlo: Wang, Jacques and Zheng, MCML, Comput. Methods Programs
// Biomed. 47, 1995, for packets of photons. A path that meets a boundary ends there and a new one
// begins behind it, as exponential paths may; integer weights make every sum exact.
#include "photon/launch.cl"

/// A photon that is lighter than this lives on with a probability of 2^-3. 2^-7 of a whole one
/// needs less time for the same error than MCML's 1e-4 (bench/photon).
#ifndef ROULETTE_BELOW
#define ROULETTE_BELOW 8388608
#endif
#define ROULETTE_LOG 3

#ifndef MOST_STEPS
#define MOST_STEPS 4194304
#endif

/// Adds what the lanes absorb here to bins [depth][radius].
static inline void count_absorbed(const packet* p, word amount, const scene* s)
{
#if ABSORBED
    const word depth = bin_of(p->top + p->z, s->depth_bins_per_cm, DEPTH_BINS);
    const word radius = radius_bin(p->x, p->y, s->radius_bins_per_cm, ABSORBED_RADIUS_BINS);
    add_weights(s->tallies, FIRST_ABSORBED, depth * (ABSORBED_RADIUS_BINS + 1) + radius, amount);
#endif
}

/// Ends photons that have made too many steps.
static inline void give_up(packet* p, mask_t lanes, const scene* s)
{
    count_deposits(p, lanes, s);
    count_total(p->weight, lanes, total_unfinished, s);
    p->weight = choose_word(lanes, (word)(0), p->weight);
}

/// The lanes of a mask are light: most of them end, the others become as much heavier.
static inline void play_roulette(packet* p, mask_t lanes, word bits, const scene* s)
{
    count_deposits(p, lanes, s);
    const mask_t wins = lanes & smaller(bits >> 2 & ((1 << ROULETTE_LOG) - 1), (word)(1));
    const word heavier = p->weight << ROULETTE_LOG;
    count_total(heavier - p->weight, wins, total_gave, s);
    count_total(p->weight, lanes & not_(wins), total_took, s);
    p->weight = choose_word(lanes, choose_word(wins, heavier, (word)(0)), p->weight);
}

/// One path of every photon, to where it is scattered or to the end of its layer.
static inline void make_step(packet* p, float bottom_albedo, const scene* s)
{
    word bits_path, bits_cosine, bits_azimuth;
    next_three(&p->random, &bits_path, &bits_cosine, &bits_azimuth);
    const mask_t alive = is_alive(p);
    const real free_path = -log_of_positive(uniform_of(bits_path)) * p->mean_free_path;
    const real gap = choose(less(p->u.z, (real)(R(0.0))), p->z, p->thickness - p->z);
    const real across = fabs(p->u.z);
    const mask_t inside = alive & less(across * free_path, gap);
    const mask_t arrives = alive & not_(inside);
    real path = free_path;
    if (any_of(arrives)) path = choose(arrives, gap / max(across, (real)(R(1e-20))), path);
    p->x = fma(p->u.x, path, p->x);
    p->y = fma(p->u.y, path, p->y);
    p->z = fma(p->u.z, path, p->z);
    p->steps += 1;
#if ROW == 2
    p->optical_path = fma(p->index, path, p->optical_path);
#endif
#if SPECTRUM
    p->path += path;
#endif

    // What is absorbed is rounded up or down by chance, so that its mean is exact.
    const word chance = (bits_path & 255) << 8 | (bits_cosine & 255);
    const real absorbed =
        fma(real_of(p->weight), p->absorbed, real_of(chance) * R(1.52587890625e-5));
    const word amount = choose_word(inside, min(word_of(absorbed), p->weight), (word)(0));
    p->weight -= amount;
    p->deposited += amount;
    count_absorbed(p, amount, s);

    const polar by = scattering_angle(&p->phase, uniform_of(bits_cosine), &p->random, s->phases);
    const direction u = turned(p->u, by, even_azimuth(bits_azimuth));
    p->u.x = choose(inside, u.x, p->u.x);
    p->u.y = choose(inside, u.y, p->u.y);
    p->u.z = choose(inside, u.z, p->u.z);
    p->scattered |= inside;
#if CLEAR_TOP
    p->met_matter |= alive & less(p->mean_free_path, (real)(R(1e30)));
#endif

    if (any_of(arrives)) meet_boundary(p, arrives, bits_cosine, bits_azimuth, bottom_albedo, s);
    const mask_t light = inside & smaller(p->weight, (word)(ROULETTE_BELOW));
    if (any_of(light)) play_roulette(p, light, bits_azimuth, s);
    const mask_t tired = alive & smaller((word)(MOST_STEPS), as_words(p->steps));
    if (any_of(tired)) give_up(p, tired, s);
}

/// Follows photons first to first + count - 1, `count` of which other launches may share. tallies:
/// sums as photon_fields.h says, one set for each work-item unless they share one; taken: 0.
kernel void transport(global ulong* restrict tallies, global uint* restrict taken,
                      global const float* restrict layers, global const float* restrict phases,
                      const uint sums, const ulong first, const uint count, const ulong seed,
                      const float sine, const float cosine, const uint weight, const float ratio,
                      const float excess, const float radius_x, const float radius_y,
                      const float bottom_albedo, const float row_bins_per_unit,
                      const float radius_bins_per_cm, const float depth_bins_per_cm,
                      const uint wavelengths)
{
    const source light = {sine, cosine, weight, ratio, excess, radius_x, radius_y};
#if !SHARED_TALLIES
    tallies += get_global_id(0) * sums;
#endif
    const scene s = {tallies,           layers,     phases, row_bins_per_unit, radius_bins_per_cm,
                     depth_bins_per_cm, wavelengths};
    const real zero = (real)(R(0.0));
    const word none = (word)(0);
    supply from = {taken, none, none, count, 1, 1, first, seed};
    packet p;
    p.x = p.y = p.z = p.u.x = p.u.y = zero;
    p.u.z = (real)(R(1.0));
    p.weight = p.deposited = none;
#if ROW == 2
    p.optical_path = zero;
#endif
#if SPECTRUM
    p.path = zero;
#define NO_PATH(k) p.paths[k] = zero;
    EACH_LAYER(NO_PATH)
#endif
    p.layer = p.steps = p.scattered = (mask_t)(0);
#if CLEAR_TOP
    p.met_matter = (mask_t)(0);
#endif
    p.random = no_stream();
    look_up_layer(&p, equal(p.layer, p.layer), &s);
    while (from.has_more || any_of(is_alive(&p))) {
        if (from.has_more && any_of(not_(is_alive(&p)))) launch(&p, &from, &light, &s);
        make_step(&p, bottom_albedo, &s);
    }
}
