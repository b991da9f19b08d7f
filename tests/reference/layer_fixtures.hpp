// SPDX-License-Identifier: Apache-2.0
// Media that files of tests/data/layers describe.
#pragma once

#include <map>
#include <string>

#include "gonio/layers.hpp"
#include "reference/csv.hpp"

namespace gonio::test {

/// Of a row of layers/slabs.csv, with an extinction of 1/cm.
LayeredMedium slab_of(const CsvRow& row);

/// The models of layers/skin_layers.csv by "name,wavelength".
std::map<std::string, LayeredMedium> skin_models();

}  // namespace gonio::test
