// SPDX-License-Identifier: Apache-2.0
// What the host prepares for the photon kernel, and what the kernel counts, read by C++ and by
// OpenCL C: the order of the fields.
#ifndef GONIO_PHOTON_FIELDS
#define GONIO_PHOTON_FIELDS

/// Per layer: one record after the other. Lengths are in cm.
enum layer_field {
    layer_mean_free_path,  ///< 1/(mua + mus); 1e30 where there is nothing to meet
    layer_absorbed,        ///< mua/(mua + mus)
    layer_thickness,
    layer_top,  ///< depth
    // Where light leaves the layer upwards and downwards: the index here over that behind the
    // boundary, and 1 minus its square.
    layer_ratio_up,
    layer_excess_up,
    layer_ratio_down,
    layer_excess_down,
    layer_g_1,       ///< Henyey-Greenstein, of the first term
    layer_g_2,       ///< of the second
    layer_weight_1,  ///< of the first, in [0, 1]
    layer_rayleigh,  ///< 1 where the phase function is Rayleigh's, else 0
    layer_index,
    layer_first_segment,  ///< of a tabulated phase function
    layer_segments,       ///< how many; 0 where there is none
    layer_fields
};

/// Per segment of a tabulated phase function between two cosines. One that is drawn evenly counts
/// with a probability of its share, else its alias does.
enum segment_field {
    segment_share,
    segment_alias,  ///< counted from the first segment of its table
    segment_low,    ///< density at the lower cosine, of any scale
    segment_high,   ///< at the upper one
    segment_end,    ///< 1 minus the upper cosine
    segment_width,  ///< difference of the cosines
    segment_fields
};

/// Where weight ends, in units of 2^-30 photons; behind these, what each layer absorbs, and then
/// the bins of the tallies. Everything but `gave` adds up to the weight that came in and `gave`.
enum photon_total {
    total_specular,     ///< leaves upwards and has met no layer that absorbs or scatters
    total_reflected,    ///< all else that leaves upwards
    total_unscattered,  ///< leaves downwards, never scattered
    total_transmitted,  ///< all else that leaves downwards
    total_bottom,       ///< absorbed by the bottom
    total_unfinished,   ///< what photons carried that have made too many steps
    total_took,         ///< by roulette
    total_gave,         ///< by roulette
    photon_totals
};

#endif
