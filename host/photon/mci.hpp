// SPDX-License-Identifier: Apache-2.0
// Reads MCML's input files (.mci), version 1.0: Wang and Jacques, Monte Carlo Modeling of Light
// Transport in Multi-layered Tissues in Standard C, 1992, section 5.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "gonio/layers.hpp"
#include "gonio/photons.hpp"

namespace gonio {

/// One run of a file.
struct MciRun {
    std::string output;  ///< name of the .mco file
    std::uint64_t photons = 0;
    LayeredMedium medium;
    PhotonTallies tallies;  ///< all three
};

/// Throws UsageError that begins with file:line and says what is expected.
std::vector<MciRun> parse_mci(std::string_view text, const std::string& file);
std::vector<MciRun> load_mci(const std::filesystem::path& path);

}  // namespace gonio
