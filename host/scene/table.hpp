// SPDX-License-Identifier: Apache-2.0
// Tables that a scene asks for.
#pragma once

#include <string>
#include <vector>

#include "scene/reader.hpp"

namespace gonio {

/// One [[table]]: of the material that it names, or else one of each. `storage` is the scene's own.
std::vector<TableRequest> read_table_requests(const Value& value,
                                              const std::vector<SceneMaterial>& materials,
                                              const Storage& storage);

/// Of "5 s", "2 min" or "1 h". Throws UsageError that begins with the name for any other text.
double seconds_of(std::string_view name, std::string_view text);

/// { kind, counts, samples, spacing, delta_phi_to }
Grid read_grid(const Value& value);

/// { kind, samples, spacing, delta_phi_to, interpolation = "linear" | "cubic" }, or nothing if the
/// grid has counts.
std::optional<GridFit> read_grid_fit(const Value& value);

/// { name = { from, to, count, samples, spacing = "linear" | "square" }, ... } or { name = { values
/// = [...] }, ... }
std::vector<Axis> read_axes(const Value& value);

/// How layers are lit, and over which bins: the keys `light`, `theta_i`, `seed` and `axes` of a
/// table of layers. Throws UsageError where the axes are not those of the quantity.
void read_light_request(const Section& table, TableRequest& request);

/// How skin is lit, and at which wavelengths. Throws UsageError where it has no layers there.
void read_skin_request(const Section& table, const Skin& skin, TableRequest& request);

/// Over what the light that spreads in skin is asked for, and with how many photons. Throws
/// UsageError where skin has no layers at a wavelength.
void read_profile_request(const Section& table, const Skin& skin, TableRequest& request);

/// Of an integral over the hemisphere: the quantity's directions, and numbers of the material.
/// Throws UsageError at the one that is neither.
void read_integral_axes(const Value& axes, const SceneMaterial& material, TableRequest& request);

/// The same of lines as they would stand in `axes`: "mu = { to = 1, count = 64 }".
void read_integral_axes(const std::vector<std::string>& lines, const SceneMaterial& material,
                        TableRequest& request);

/// The keys `format`, `precision` and `compression` of a section, where it has them.
void read_storage(const Section& section, Storage& storage);

}  // namespace gonio
