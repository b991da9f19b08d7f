// SPDX-License-Identifier: Apache-2.0
// The device at hard spots, beside what textbook forms make of them.
#pragma once

#include <string>
#include <vector>

#include "gonio/device.hpp"
#include "gonio/photons.hpp"
#include "verify/accuracy.hpp"
#include "verify/hard_spots.hpp"

namespace gonio {

struct SpotVerdict {
    std::string name;
    Accuracy device;    ///< against the reference in double
    Accuracy textbook;  ///< the same of the textbook's form in float32
    double bound = 0;   ///< of the device's relative error
    /// By how much more of itself than a direction's coordinates f changes, at most.
    double condition = 0;
    bool passed() const;
};

SpotVerdict verify_spot(const Device& device, const HardSpot& spot);

/// A number that photons find and that is known exactly.
struct MediumVerdict {
    std::string name;
    double exact = 0, measured = 0, standard_error = 0;
    double deviation = 0;  ///< in standard errors
    double bound = 0;      ///< of the deviation: 1 % for all media together (Sidak)
    bool passed() const { return deviation <= bound; }
};

/// Layers at the ends of what light meets: reflectance by photons against adding-doubling. Throws
/// CheckFailed where a photon's weight is lost.
std::vector<MediumVerdict> verify_media(const Device& device);

/// More than 10^10 photons of weight 1 in one bin, as tallies add them up and as a float32 would.
struct SumVerdict {
    double photons = 0;
    double error = 0;           ///< relative
    double textbook_error = 0;  ///< relative, of one float32 that each photon adds to
    bool passed() const { return error == 0; }
};

SumVerdict verify_sum();

}  // namespace gonio
