// SPDX-License-Identifier: Apache-2.0
// A material as a weighted sum of lobes. The program's first lines, written by the host, define
//   - LOBES: LOBE(0, ward, 0, 1) LOBE(1, lambert, 0, 1) ...: number, model, whether it prints a
//     value, which contains cos theta_i, whether it has a weight that is not 1
//   - CHOICES: the chosen options of all lobes, in order
//   - SHARED: for all colours of all lobes, in order, whether all channels have the same
//   - MEASURE: measure_as_printed, measure_brdf or measure_brdf_cosine
#ifndef GONIO_CORE_MATERIAL
#define GONIO_CORE_MATERIAL
#include "core/lobe.cl"

#ifndef LOBES
#include "brdf/lambert.cl"
#define LOBES LOBE(0, lambert, 0, 0)
#define CHOICES 0
#define SHARED 0
#endif

#define measure_as_printed 0
#define measure_brdf 1
#define measure_brdf_cosine 2
#ifndef MEASURE
#define MEASURE measure_brdf
#endif

constant const int material_choices[] = {CHOICES};
constant const int material_shared[] = {SHARED};

typedef struct {
#define LOBE(number, id, is_value, is_weighted) \
    id##_params lobe_##number;                  \
    float weight_##number[CHANNELS];
    LOBES
#undef LOBE
} material;

/// Parameters and weight of each lobe, in the order of the registry.
static inline void load_material(material* m, global const float* values)
{
    constant const int* choices = material_choices;
    constant const int* shared = material_shared;
#define LOBE(number, id, is_value, is_weighted)               \
    id##_load(&m->lobe_##number, &values, &choices, &shared); \
    FOR_CHANNELS(c) m->weight_##number[c] = *values++;
    LOBES
#undef LOBE
}

/// The factor between what a model prints and what was asked for.
static inline real measure_factor(int is_value, const directions* d)
{
#if MEASURE == measure_brdf
    return is_value ? R(1.0) / d->cos_i : (real)(R(1.0));
#elif MEASURE == measure_brdf_cosine
    return is_value ? (real)(R(1.0)) : d->cos_i;
#else
    return (real)(R(1.0));
#endif
}

static inline void evaluate_material(const material* m, const directions* d, real f[CHANNELS])
{
#define LOBE(number, id, is_value, is_weighted)                                    \
    {                                                                              \
        real lobe[CHANNELS];                                                       \
        id##_eval(&m->lobe_##number, d, lobe);                                     \
        const real factor = measure_factor(is_value, d);                           \
        FOR_CHANNELS(c)                                                            \
        {                                                                          \
            const real value = lobe[c] * factor;                                   \
            const real term = is_weighted ? m->weight_##number[c] * value : value; \
            f[c] = number == 0 ? term : f[c] + term;                               \
        }                                                                          \
    }
    LOBES
#undef LOBE
}

#endif
