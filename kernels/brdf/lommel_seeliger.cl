// SPDX-License-Identifier: Apache-2.0
// Seeliger 1888; Hapke, Theory of reflectance and emittance spectroscopy, 2nd ed., 2012, 8.5:
// w/(4 pi (n.l + n.v)).
#include "core/lobe.cl"

static inline void lommel_seeliger_eval(const lommel_seeliger_params* p, const directions* d,
                                        real f[CHANNELS])
{
    const real lobe = (R(1.0) / (R(8.0) * PI)) / d->mean_cos;
    FOR_CHANNELS(c) f[c] = p->w[c] * lobe;
}
