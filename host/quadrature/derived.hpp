// SPDX-License-Identifier: Apache-2.0
// Quantities that are made of albedos.
#pragma once

#include <string>
#include <vector>

#include "gonio/albedo.hpp"
#include "gonio/job.hpp"

namespace gonio {

/// The channels of a table of such a quantity: those of the material, or scale and bias; and behind
/// them a bound of the error of each, ".error".
std::vector<std::string> derived_channels(const std::string& quantity, const Material& material);

/// Throws UsageError for a material that has no such quantity.
void check_derived(const std::string& quantity, const Material& material);

/// What is integrated for a job's table: of split sums both ends of f0, of Kulla-Conty facets that
/// reflect all light, else its materials.
std::vector<Material> integrated_materials(const Job& job);

/// values[channel][cell] of job.cells, in the order of job.header.
struct DerivedTable {
    std::vector<std::vector<double>> values;
    double largest_error = 0;
    Albedos spent;  ///< order, evaluations and seconds
};

DerivedTable derive(const Device& device, const Job& job);

/// 2 times the integral of the directional albedo times mu over mu, and over azimuths:
/// value[channel][material]. seconds: as AlbedoOptions.
Albedos mean_albedos(const Device& device, const std::vector<Material>& materials, double max_error,
                     double seconds);

}  // namespace gonio
