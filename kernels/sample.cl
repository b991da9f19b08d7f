// SPDX-License-Identifier: Apache-2.0
// Importance sampling of a material: random viewers for a fixed light, how dense they are, and what
// each is worth. Every lobe is sampled as often as the others, whatever its weight.
#include "core/material.cl"
#include "directions/offset.cl"
#include "gonio/shared/sample_fields.h"

#define LOBE(number, id, is_value, is_weighted) +1
enum { lobe_count = 0 LOBES };
#undef LOBE

static inline mirror_offset sample_material(const material* m, const fixed_light* l, stream* random)
{
    const mask_t chosen = bits_of(high_word(next_word(random), lobe_count));
    mirror_offset o = {(real)(R(0.0)), (real)(R(0.0)), (real)(R(0.0))};
#define LOBE(number, id, is_value, is_weighted)                              \
    {                                                                        \
        stream own = *random;                                                \
        const mirror_offset found = id##_sample(&m->lobe_##number, l, &own); \
        o = choose_offset(equal(chosen, (mask_t)(number)), found, o);        \
    }
    LOBES
#undef LOBE
    return o;
}

static inline real material_pdf(const material* m, const directions* d)
{
    real sum = (real)(R(0.0));
#define LOBE(number, id, is_value, is_weighted) sum += id##_pdf(&m->lobe_##number, d);
    LOBES
#undef LOBE
    return sum * (R(1.0) / (float)lobe_count);
}

static inline mask_t above_horizon(const directions* d)
{
    return less((real)(R(0.0)), d->cos_o);
}

/// light: cosine in two floats, sine, and cosine and sine of the azimuth.
static inline fixed_light light_of(global const float* light)
{
    const fixed_light l = {
        light[0], light[1], light[2], light[3], light[4], light[2] * light[3], light[2] * light[4]};
    return l;
}

/// out: [sample field or channel's weight][sample], for samples first and on.
kernel void sample(global float* restrict out, global const float* restrict parameters,
                   global const float* restrict light, const ulong first, const ulong seed)
{
    material m;
    load_material(&m, parameters);
    const fixed_light l = light_of(light);
    const uint at = (uint)get_global_id(0) * WIDTH;
    uint offsets[WIDTH];
    for (uint i = 0; i < WIDTH; ++i) offsets[i] = at + i;
    stream random = numbered_stream(first, load_words(offsets), seed);
    const directions d = directions_of_offset(&l, sample_material(&m, &l, &random));
    const mask_t above = above_horizon(&d);
    const real pdf = choose(above, material_pdf(&m, &d), (real)(R(0.0)));
    const real scale = d.cos_o / pdf;
    const mask_t counts = less((real)(R(0.0)), pdf);
    real f[CHANNELS];
    evaluate_material(&m, &d, f);
    const size_t plane = get_global_size(0) * WIDTH;
    store(d.x_o, out + sample_x * plane + at);
    store(d.y_o, out + sample_y * plane + at);
    store(d.cos_o, out + sample_z * plane + at);
    store(pdf, out + sample_pdf * plane + at);
    FOR_CHANNELS(c)
    {
        store(choose(counts, f[c] * scale, (real)(R(0.0))),
              out + (sample_weights + (size_t)c) * plane + at);
    }
}

/// The density of samples at given viewers. out: [viewer]; viewers: [offset field][viewer].
kernel void density(global float* restrict out, global const float* restrict parameters,
                    global const float* restrict light, global const float* restrict viewers)
{
    material m;
    load_material(&m, parameters);
    const fixed_light l = light_of(light);
    const size_t at = get_global_id(0) * WIDTH, plane = get_global_size(0) * WIDTH;
    const mirror_offset o = {load(viewers + offset_x * plane + at),
                             load(viewers + offset_y * plane + at),
                             load(viewers + offset_z * plane + at)};
    const directions d = directions_of_offset(&l, o);
    store(choose(above_horizon(&d), material_pdf(&m, &d), (real)(R(0.0))), out + at);
}
