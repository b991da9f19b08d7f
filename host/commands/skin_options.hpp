// SPDX-License-Identifier: Apache-2.0
// What `gonio skin` is asked for, from the words of its command line.
#pragma once

#include <string>
#include <vector>

#include "skin/skin_sets.hpp"

namespace gonio {

struct SkinOptions {
    std::string model = "meglinski_2002";
    std::string wavelengths;  ///< FROM:TO:STEP, or a list; empty: 380:780:5
    std::string light = "beam";
    double theta_i = 0;  ///< degrees
    double error = 1e-4;
    bool json = false;
    std::vector<std::string> files;
    std::string fit, column, free;  ///< of --fit: file, name of its column, names with commas
};

/// .png or .svg
bool is_picture(const std::string& file);

/// `words`: --parameter value, --parameter a,b,c or --parameter from:to:count[:log]. Throws
/// UsageError with the nearest name or the range.
SkinTask task_of(const SkinOptions& options, const std::vector<std::string>& words);

/// The parameters that a fit changes, as indices: those named `free`, or else all that neither the
/// model holds nor the words set. Throws UsageError with the nearest name.
std::vector<std::size_t> free_parameters(const SkinOptions& options, const SkinModel& model,
                                         const std::vector<std::string>& words);

}  // namespace gonio
