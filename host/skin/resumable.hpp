// SPDX-License-Identifier: Apache-2.0
// Light that spreads in skin, followed from where an earlier run ended before its time.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>

#include "gonio/profile.hpp"

namespace gonio {

/// Called after each launch with the part that is done, and a function that tells what it takes to
/// go on from there. What it throws ends the work.
using AfterLaunch =
    std::function<void(double part_done, const std::function<nlohmann::ordered_json()>& state)>;

/// As the functions of the same names, to the same values. from: what an earlier run with the same
/// arguments told of its state, on any device; null for none.
RadialSpectrum trace_spectrum(const Device& device, const Skin& skin,
                              const std::vector<double>& wavelengths, const ProfileRequest& request,
                              const nlohmann::ordered_json& from, const AfterLaunch& after_launch);
RadialProfile trace_profile(const Device& device, const std::vector<ColourBand>& bands,
                            const ProfileRequest& request, const nlohmann::ordered_json& from,
                            const AfterLaunch& after_launch);

}  // namespace gonio
