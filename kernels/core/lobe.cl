// SPDX-License-Identifier: Apache-2.0
// What every reflectance model includes: numbers, directions, channels and the parameter structs
// made from the registry.
#ifndef GONIO_CORE_LOBE
#define GONIO_CORE_LOBE
#include "core/facet_normals.cl"
#include "core/fresnel.cl"
#include "core/math.cl"
#include "core/microfacet.cl"
#include "core/power.cl"
#include "core/sampling.cl"
#include "directions/directions.cl"
#include "gonio/shared/residual_fields.h"

#ifndef CHANNELS
#define CHANNELS 1
#endif
// Unrolled, so that what channels share is computed once.
#define FOR_CHANNELS(c) _Pragma("unroll") for (int c = 0; c < CHANNELS; ++c)

// The options of every choice: enum { torrance_sparrow_ndf_ggx, ... }
#define CHOICE(id, name, preset, doc) enum {
#define OPTION(id, name, option, traits, doc) id##_##name##_##option,
#define END_CHOICE(id, name) \
    }                        \
    ;
#include "gonio/shared/models.inc"

// typedef struct { ... } ward_params;
#define MODEL(id, title, citation, traits) typedef struct {
#define SCALAR(id, name, unit, least, greatest, preset, doc) float name;
#define COLOR(id, name, unit, least, greatest, preset, doc) float name[CHANNELS];
#define TABLE(id, name, doc) global const float* name;
#define CHOICE(id, name, preset, doc) int name;
#define END_MODEL(id) \
    }                 \
    id##_params;
#include "gonio/shared/models.inc"

// void ward_load(ward_params *p, global const float **values, constant int **choices, constant int
// **shared): in the order of the block. A colour that is shared is one number in every channel, so
// that what follows of it is computed once.
#define MODEL(id, title, citation, traits)                                                  \
    static inline void id##_load(id##_params* p, global const float** values,               \
                                 constant const int** choices, constant const int** shared) \
    {
#define SCALAR(id, name, unit, least, greatest, preset, doc) p->name = *(*values)++;
#define COLOR(id, name, unit, least, greatest, preset, doc)   \
    FOR_CHANNELS(c) p->name[c] = (*values)[**shared ? 0 : c]; \
    *values += CHANNELS;                                      \
    ++*shared;
#define TABLE(id, name, doc) \
    p->name = *values;       \
    *values += (int)(*values)[residual_size];
#define CHOICE(id, name, preset, doc) p->name = *(*choices)++;
#define END_MODEL(id) }
#include "gonio/shared/models.inc"

/// In place of an option: facets that reflect all light.
#define facets_reflect_all (-1)

/// The reflectance of a facet: FACET_FRESNEL of the registry. at: an incidence
#define FACET_REFLECTANCE(id, p, c, at)                                                          \
    ((p)->fresnel == facets_reflect_all        ? (real)(R(1.0))                                  \
     : (p)->fresnel == id##_fresnel_conductor  ? fresnel_conductor((p)->eta[c], (p)->k[c], (at)) \
     : (p)->fresnel == id##_fresnel_dielectric ? fresnel_dielectric((p)->eta[c], (at))           \
                                               : fresnel_schlick((p)->f0[c], (at).cosine))

#endif
