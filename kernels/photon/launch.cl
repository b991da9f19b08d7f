// SPDX-License-Identifier: Apache-2.0
// Gives lanes without a photon the next ones.
#ifndef GONIO_PHOTON_LAUNCH
#define GONIO_PHOTON_LAUNCH
#include "photon/boundary.cl"

/// Photons of the launch that a lane takes at a time. On a processor the counter is what few lanes
/// wait for; a graphics card has so many that there is little for each.
#if SHARED_TALLIES
#define PORTION 1
#else
#define PORTION 32
#endif

/// Photons that are still to be followed.
typedef struct {
    global uint* taken;  ///< by the lanes of all work-items
    word next, end;      ///< of each lane's portion
    uint count;          ///< of the launch
    uint has_portions;   ///< whether some may not be taken yet
    uint has_more;       ///< whether some may not have begun yet
    ulong first, seed;
} supply;

/// Gives the lanes of a mask portions, as long as there are some.
static inline void take_portions(supply* from, mask_t lanes)
{
    uint wants[WIDTH], next[WIDTH], end[WIDTH];
    store_words(as_words(lanes), wants);
    store_words(from->next, next);
    store_words(from->end, end);
    FOR_LANES(i)
    {
        if (wants[i] == 0 || !from->has_portions) continue;
        next[i] = min(atomic_add(from->taken, (uint)PORTION), from->count);
        end[i] = min(next[i] + PORTION, from->count);
        from->has_portions = end[i] < from->count;
    }
    from->next = load_words(next);
    from->end = load_words(end);
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
    const mask_t lanes = not_(is_alive(p));
    const mask_t empty = lanes & not_(smaller(from->next, from->end));
    if (from->has_portions && any_of(empty)) take_portions(from, empty);
    const word offset = from->next;
    const mask_t starts = lanes & smaller(offset, from->end);
    from->next -= as_words(starts);
    from->has_more = from->has_portions || any_of(smaller(from->next, from->end));
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
    p->random = choose_stream(starts, random, p->random);
    p->steps = choose_count(starts, (mask_t)(0), p->steps);
    p->layer = choose_count(starts, (mask_t)(0), p->layer);
    p->scattered &= not_(starts);
#if CLEAR_TOP
    p->met_matter &= not_(starts);
#endif
    look_up_layer(p, starts, s);
}

#endif
