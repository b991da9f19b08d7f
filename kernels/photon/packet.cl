// SPDX-License-Identifier: Apache-2.0
// Photons that a work-item follows in lockstep, one in each lane, and what they have of the layer
// they are in. Options of the program, with what they mean:
//   - LAYERS: how many; EACH_LAYER(DO): DO(0) DO(1) and so on, since loops over them crash PoCL 3.1
//   - BOTTOM: 0 open, 1 mirror, 2 diffuse (a black one has an albedo of 0)
//   - SOURCE: 0 a pencil beam, 1 a Gaussian and 2 an even one, 3 Lambertian light
//   - CLEAR_TOP: the first layer neither absorbs nor scatters
//   - REFLECTED, TRANSMITTED: tally by [row][angle]; ABSORBED by [depth][radius]
//   - ROW: what rows are, 0 distance from the axis, 1 azimuth, 2 length of the optical path; by
//     azimuth only what was scattered is told apart
//   - SPECTRUM: tally reflected light at several wavelengths (photon/spectrum.cl)
#ifndef GONIO_PHOTON_PACKET
#define GONIO_PHOTON_PACKET
#include "photon/phase.cl"
#include "photon/tally.cl"

#ifndef LAYERS
#define LAYERS 1
#define EACH_LAYER(DO) DO(0)
#endif
#ifndef BOTTOM
#define BOTTOM 0
#endif
#ifndef SOURCE
#define SOURCE 0
#endif
#ifndef CLEAR_TOP
#define CLEAR_TOP 0
#endif
#ifndef REFLECTED
#define REFLECTED 0
#endif
#ifndef TRANSMITTED
#define TRANSMITTED 0
#endif
#ifndef ABSORBED
#define ABSORBED 0
#endif
#ifndef ROW
#define ROW 0
#endif
#ifndef SPECTRUM
#define SPECTRUM 0
#endif

#define WHOLE_PHOTON 1073741824u

typedef struct {
    real x, y, z;    ///< cm; z from the top of the layer
    direction u;     ///< z points down
    word weight;     ///< in units of 2^-30; 0 where a lane has no photon
    word deposited;  ///< in this layer, and not yet counted
    mask_t layer, steps;
    mask_t scattered;
#if CLEAR_TOP
    mask_t met_matter;
#endif
    stream random;
    real mean_free_path, absorbed, thickness;
#if ABSORBED
    real top;
#endif
#if ROW == 2
    real index, optical_path;
#endif
#if SPECTRUM
    real path;           ///< in this layer, and not yet in
    real paths[LAYERS];  ///< cm
#endif
    phase_function phase;
} packet;

/// What all photons of a launch share.
typedef struct {
    global ulong* tallies;
    global const float *layers, *phases;
    float row_bins_per_unit, radius_bins_per_cm, depth_bins_per_cm;
    uint wavelengths;
} scene;

static inline float layer_value(const scene* s, int layer, int field)
{
    return s->layers[layer * layer_fields + field];
}

/// Gives the lanes of a mask what belongs to the layers they are in.
static inline void look_up_layer(packet* p, mask_t lanes, const scene* s)
{
#define LOOK_UP(k, member, field) \
    member = choose(here, (real)(layer_value(s, k, layer_##field)), member);
#if ABSORBED
#define LOOK_UP_TOP(k) LOOK_UP(k, p->top, top)
#else
#define LOOK_UP_TOP(k)
#endif
#if ROW == 2
#define LOOK_UP_INDEX(k) LOOK_UP(k, p->index, index)
#else
#define LOOK_UP_INDEX(k)
#endif
#if TWO_TERMS
#define LOOK_UP_TERMS(k) LOOK_UP(k, p->phase.g_2, g_2) LOOK_UP(k, p->phase.weight_1, weight_1)
#else
#define LOOK_UP_TERMS(k)
#endif
#if RAYLEIGH
#define LOOK_UP_RAYLEIGH(k) LOOK_UP(k, p->phase.rayleigh, rayleigh)
#else
#define LOOK_UP_RAYLEIGH(k)
#endif
#if TABULATED
#define LOOK_UP_TABLE(k)                              \
    LOOK_UP(k, p->phase.first_segment, first_segment) \
    LOOK_UP(k, p->phase.segments, segments)
#else
#define LOOK_UP_TABLE(k)
#endif
#define LOOK_UP_LAYER(k)                                                                      \
    {                                                                                         \
        const mask_t here = lanes & equal(p->layer, (mask_t)(k));                             \
        LOOK_UP(k, p->mean_free_path, mean_free_path)                                         \
        LOOK_UP(k, p->absorbed, absorbed)                                                     \
        LOOK_UP(k, p->thickness, thickness)                                                   \
        LOOK_UP(k, p->phase.g_1, g_1)                                                         \
        LOOK_UP_TOP(k) LOOK_UP_INDEX(k) LOOK_UP_TERMS(k) LOOK_UP_RAYLEIGH(k) LOOK_UP_TABLE(k) \
    }
    EACH_LAYER(LOOK_UP_LAYER)
}

static inline mask_t is_alive(const packet* p)
{
    return smaller((word)(0), p->weight);
}

/// Counts what the lanes of a mask have left in their layers. In few layers a sum for each of them
/// takes less time than one after the other of the lanes.
static inline void count_deposits(packet* p, mask_t lanes, const scene* s)
{
    const word deposits = choose_word(lanes, p->deposited, (word)(0));
#if LAYERS <= 3
#define COUNT_DEPOSIT(k)                                            \
    {                                                               \
        const mask_t here = equal(p->layer, (mask_t)(k));           \
        add_weight(s->tallies, photon_totals + (k),                 \
                   sum_of(choose_word(here, deposits, (word)(0)))); \
    }
    EACH_LAYER(COUNT_DEPOSIT)
#else
    add_weights(s->tallies, photon_totals, as_words(p->layer), deposits);
#endif
    p->deposited = choose_word(lanes, (word)(0), p->deposited);
}

/// Adds the weight of the lanes of a mask to one of the totals.
static inline void count_total(word weight, mask_t lanes, uint total, const scene* s)
{
    add_weight(s->tallies, total, sum_of(choose_word(lanes, weight, (word)(0))));
}

#endif
