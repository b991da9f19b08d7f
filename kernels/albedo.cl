// SPDX-License-Identifier: Apache-2.0
// The integral of f cos over the hemisphere, by products of Gauss rules. Each lane sums one cell, a
// direction and a row of parameters, so that the sum's order does not depend on the width.
#include "core/material.cl"
#include "directions/quadrature.cl"

#define CELL_FIELD(name) load(cells + ((ulong)group * cell_fields + cell_##name) * WIDTH)
#define NODE_FIELD(name) load(record + (ulong)node_##name * WIDTH)

static inline azimuth_node load_node(global const float* record)
{
    const azimuth_node node = {NODE_FIELD(cos),       NODE_FIELD(sin),   NODE_FIELD(frame_cos),
                               NODE_FIELD(frame_sin), NODE_FIELD(scale), NODE_FIELD(from),
                               NODE_FIELD(span),      NODE_FIELD(end),   NODE_FIELD(weight)};
    return node;
}

/// out: [channel][high, low][group][lane]. parameters: [row][parameter_count]. cells: [group][cell
/// field][lane]. nodes: [node][node field][lane]. rule: positions in [0, 1] and weights in turn.
/// reversed: the cell's direction is the viewer's.
kernel void albedo(global float* restrict out, global const float* restrict parameters,
                   const uint parameter_count, global const uint* restrict groups,
                   global const float* restrict cells, global const float* restrict nodes,
                   global const float* restrict rule, const uint rule_count, const int map,
                   const int reversed_light)
{
    const size_t group = get_global_id(0);
    material m;
    load_material(&m,
                  parameters + (ulong)groups[group * group_fields + group_row] * parameter_count);
    const two_floats cosine = {CELL_FIELD(cos_hi), CELL_FIELD(cos_lo)};
    const fixed_direction l = {cosine, CELL_FIELD(sin), CELL_FIELD(cos_phi), CELL_FIELD(sin_phi)};

    two_floats sum[CHANNELS];
    FOR_CHANNELS(c) sum[c].hi = sum[c].lo = (real)(R(0.0));
    const ulong first = groups[group * group_fields + group_first];
    const uint count = groups[group * group_fields + group_count];
    for (uint n = 0; n < count; ++n) {
        const azimuth_node node = load_node(nodes + (first + n) * (node_fields * WIDTH));
        const real width = node.span * node.weight;
        for (uint k = 0; k < rule_count; ++k) {
            const real t = node.from + node.span * rule[2 * k];
            const quadrature_point p = point_of_node(map, &l, &node, t);
            directions d = directions_of_point(map, &l, &node, &p);
            if (reversed_light) reverse_light(&d);
            real f[CHANNELS];
            evaluate_material(&m, &d, f);
            const real weight = rule[2 * k + 1] * width * (p.weight * p.cosine);
            FOR_CHANNELS(c)
            {
                const two_floats term = {weight * f[c], (real)(R(0.0))};
                sum[c] = two_floats_plus(sum[c], term);
            }
        }
    }
    const size_t plane = get_global_size(0) * WIDTH;
    FOR_CHANNELS(c)
    {
        global float* to = out + 2 * (ulong)c * plane + group * WIDTH;
        store(sum[c].hi, to);
        store(sum[c].lo, to + plane);
    }
}
