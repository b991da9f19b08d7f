// SPDX-License-Identifier: Apache-2.0
// Writes a buffer and computes nothing: the roof that tables are measured against.
#include "core/real.cl"

/// out: count floats, a multiple of WIDTH. Each work-item fills a block of its own, as kernel
/// `table` does.
kernel void store_only(global float* restrict out, const ulong count)
{
    const ulong vectors = count / WIDTH;
    const ulong begin = vectors * get_global_id(0) / get_global_size(0);
    const ulong end = vectors * (get_global_id(0) + 1) / get_global_size(0);
    const real value = (real)((float)get_global_id(0));
    for (ulong k = begin; k < end; ++k) store(value, out + k * WIDTH);
}
