// SPDX-License-Identifier: Apache-2.0
// Writes MCML's output (.mco), for programs that read it.
#pragma once

#include <string>

#include "photon/mci.hpp"

namespace gonio {

/// What a run is asked for, as the block InParm of a .mco file.
std::string mco_parameters(const MciRun& run);

/// The text of a .mco file, format A1, from a run's result. Its units are MCML's; what lies beyond
/// the last bins is left out of them, where MCML adds it to the last ones.
std::string mco_text(const MciRun& run, const PhotonResult& result);

}  // namespace gonio
