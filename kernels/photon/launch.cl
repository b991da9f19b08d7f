// SPDX-License-Identifier: Apache-2.0
// Gives lanes without a photon the next ones.
#ifndef GONIO_PHOTON_LAUNCH
#define GONIO_PHOTON_LAUNCH
#include "photon/boundary.cl"

/// Photons of the launch that a work-item takes at a time.
#define PORTION (4 * WIDTH)

/// Photons that are still to be followed.
typedef struct {
    global uint* taken;  ///< by all work-items
    uint next, end;      ///< of this work-item's portion
    uint count;          ///< of the launch
    ulong first, seed;
} supply;

/// The number of one more photon, counted from the launch's first; count if there is none.
static inline uint take_photon(supply* from)
{
    if (from->next == from->end && from->end < from->count) {
        from->next = min(atomic_add(from->taken, (uint)PORTION), from->count);
        from->end = min(from->next + PORTION, from->count);
    }
    if (from->next == from->end) {
        from->next = from->end = from->count;
        return from->count;
    }
    return from->next++;
}

/// Where photons come in: a beam that has been refracted already, or diffuse light.
typedef struct {
    float sine, cosine;
    uint weight;
    float ratio, excess;  ///< as a layer's, from above into the first layer
} source;

/// Starts photons in the lanes that have none, as long as there are some.
static inline void launch(packet* p, supply* from, const source* light, const scene* s)
{
    uint weights[WIDTH], offsets[WIDTH];
    store_words(p->weight, weights);
    FOR_LANES(i)
    {
        offsets[i] = weights[i] == 0 ? take_photon(from) : from->count;
    }
    const word offset = load_words(offsets);
    const mask_t starts = smaller(offset, (word)(from->count));
    stream random = numbered_stream(from->first, offset, from->seed);
    direction u = {(real)(light->sine), (real)(R(0.0)), (real)(light->cosine)};
    word weight = (word)(light->weight);
#if DIFFUSE_SOURCE
    const real sine2 = uniform_of(next_word(&random));
    const refraction at =
        refracted(sqrt(R(1.0) - sine2), (real)(light->ratio), (real)(light->excess));
    const real reflected = fma(at.reflectance, (real)(R(1073741824.0)), (real)(R(0.5)));
    const word specular = min(word_of(reflected), (word)(WHOLE_PHOTON));
    count_total(specular, starts, total_specular, s);
    weight = (word)(WHOLE_PHOTON)-specular;
    u.x = sqrt(sine2) * light->ratio;
    u.z = at.cosine;
#endif
    const real zero = (real)(R(0.0));
    p->x = choose(starts, zero, p->x);
    p->y = choose(starts, zero, p->y);
    p->z = choose(starts, zero, p->z);
    p->u.x = choose(starts, u.x, p->u.x);
    p->u.y = choose(starts, u.y, p->u.y);
    p->u.z = choose(starts, u.z, p->u.z);
    p->weight = choose_word(starts, weight, p->weight);
    p->random.a = choose_word(starts, random.a, p->random.a);
    p->random.b = choose_word(starts, random.b, p->random.b);
    p->random.c = choose_word(starts, random.c, p->random.c);
    p->random.d = choose_word(starts, random.d, p->random.d);
    p->steps = choose_count(starts, (mask_t)(0), p->steps);
    p->layer = choose_count(starts, (mask_t)(0), p->layer);
    p->scattered &= not_(starts);
#if CLEAR_TOP
    p->met_matter &= not_(starts);
#endif
    look_up_layer(p, starts, s);
}

#endif
