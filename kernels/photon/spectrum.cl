// SPDX-License-Identifier: Apache-2.0
// Reflected light at many wavelengths of one path: absorption that is added to the layers' takes
// exp(-sum of absorption times path) of its weight, exactly (Sassaroli, Martelli, J. Opt. Soc. Am.
// A 29, 2110, 2012). Options of the program:
//   - SPECTRUM: 0 compiles nothing of it
//   - SPECTRUM_ROWS: bins of the distance from the axis, and one for what lies beyond. Behind these
//     rows, [row][wavelength], comes one of all light and one of its squared weights
#ifndef GONIO_PHOTON_SPECTRUM
#define GONIO_PHOTON_SPECTRUM
#include "photon/packet.cl"

#if SPECTRUM
/// Counts the lanes' paths since the last time for the layers they are in.
static inline void end_paths(packet* p, mask_t lanes)
{
#define END_PATH(k)                                               \
    {                                                             \
        const mask_t here = lanes & equal(p->layer, (mask_t)(k)); \
        p->paths[k] += choose(here, p->path, (real)(R(0.0)));     \
    }
    EACH_LAYER(END_PATH)
    p->path = choose(lanes, (real)(R(0.0)), p->path);
}

/// Adds a photon that leaves to the bins of all wavelengths, as many at a time as there are lanes.
/// paths: in each layer, WIDTH apart.
static inline void count_wavelengths(uint weight, uint row, const uint* paths, const scene* s)
{
    // A layer's numbers are padded to the widest vectors.
    const uint wavelengths = s->wavelengths, stride = (wavelengths + 15) / 16 * 16;
    global const float* absorption = s->layers + LAYERS * layer_fields;
    for (uint first = 0; first < wavelengths; first += WIDTH) {
        real depth = (real)(R(0.0));
#define ADD_DEPTH(k) \
    depth = fma(load(absorption + (k)*stride + first), (real)(as_float(paths[(k)*WIDTH])), depth);
        EACH_LAYER(ADD_DEPTH)
        const real part = exp_of_negative(depth) * (float)weight;
        const word left = min(word_of(part + R(0.5)), (word)(weight));
        uint lefts[WIDTH], squares[WIDTH];
        store_words(left, lefts);
        store_words(word_of(square(real_of(left) * R(3.0517578125e-5))), squares);
        for (uint i = 0; i < WIDTH && first + i < wavelengths; ++i) {
            const uint place = FIRST_SPECTRUM + first + i;
            add_weight(s->tallies, place + row * wavelengths, lefts[i]);
            add_weight(s->tallies, place + SPECTRUM_ROWS * wavelengths, lefts[i]);
            add_weight(s->tallies, place + (SPECTRUM_ROWS + 1) * wavelengths, squares[i]);
        }
    }
}

/// Counts what the lanes of a mask reflect.
static inline void count_spectrum(const packet* p, mask_t lanes, const scene* s)
{
    uint weights[WIDTH], rows[WIDTH], paths[LAYERS * WIDTH];
    store_words(choose_word(lanes, p->weight, (word)(0)), weights);
    store_words(radius_bin(p->x, p->y, s->row_bins_per_unit, SPECTRUM_ROWS - 1), rows);
#define STORE_PATHS(k) store_words(as_words(p->paths[k]), paths + (k)*WIDTH);
    EACH_LAYER(STORE_PATHS)
    FOR_LANES(i)
    {
        if (weights[i] != 0) count_wavelengths(weights[i], rows[i], paths + i, s);
    }
}
#endif

#endif
