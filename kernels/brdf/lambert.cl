// SPDX-License-Identifier: Apache-2.0
// Lambert, Photometria, 1760.
#include "core/lobe.cl"

static inline void lambert_eval(const lambert_params* p, const directions* d, real f[CHANNELS])
{
    FOR_CHANNELS(c) f[c] = (real)(p->rho[c] / PI);
}
