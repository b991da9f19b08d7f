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
    float ratio, excess;       ///< as a layer's, from above into the first layer
    float radius_x, radius_y;  ///< of the beam's ellipse on the surface, cm
} source;

#if SOURCE == 1 || SOURCE == 2
/// Where a beam that is not a pencil meets the surface. A Gaussian has fallen to 1/e^2 at its
/// radius.
static inline void spread(const source* light, stream* random, real* x, real* y)
{
    const real u = uniform_of(next_word(random));
#if SOURCE == 1
    const real distance = sqrt(R(-0.5) * log_of_positive(u));
#else
    const real distance = sqrt(u);
#endif
    const azimuth about = even_azimuth(next_word(random));
    *x = distance * about.cosine * light->radius_x;
    *y = distance * about.sine * light->radius_y;
}
#endif

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
    real x = (real)(R(0.0)), y = (real)(R(0.0));
#if SOURCE == 1 || SOURCE == 2
    spread(light, &random, &x, &y);
#elif SOURCE == 3
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
    p->x = choose(starts, x, p->x);
    p->y = choose(starts, y, p->y);
    p->z = choose(starts, (real)(R(0.0)), p->z);
#if ROW == 2
    p->optical_path = choose(starts, (real)(R(0.0)), p->optical_path);
#endif
#if SPECTRUM
    p->path = choose(starts, (real)(R(0.0)), p->path);
#define START_PATH(k) p->paths[k] = choose(starts, (real)(R(0.0)), p->paths[k]);
    EACH_LAYER(START_PATH)
#endif
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
