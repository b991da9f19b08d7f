// SPDX-License-Identifier: Apache-2.0
// Parameters of a model of skin that explain a measured spectrum.
#pragma once

#include <string>
#include <vector>

#include "gonio/skin.hpp"
#include "skin/spectrum.hpp"

namespace gonio {

struct FittedParameter {
    std::size_t index = 0;  ///< into SkinModel::parameters
    double value = 0;
    double error = 0;  ///< standard error, if residuals are noise; infinite where nothing tells
    bool at_limit = false;  ///< of its range
};

struct SkinFit {
    Skin skin;  ///< with the fitted parameters
    std::vector<FittedParameter> parameters;
    SkinSpectrum spectrum;                                             ///< of it
    std::vector<double> measured;                                      ///< at the same wavelengths
    double mean_residual = 0, rms_residual = 0, largest_residual = 0;  ///< absolute reflectance
};

/// Least squares over `wavelengths` (nm) by Levenberg and Marquardt (Moré, in Numerical Analysis,
/// Lecture Notes in Mathematics 630, 1978: MINPACK), from the parameters of `start`; all but those
/// in `varied`, indices into SkinModel::parameters, stay. Throws UsageError where the measurement
/// does not cover the wavelengths or has fewer points than there are parameters.
SkinFit fit_skin(const Skin& start, const std::vector<std::size_t>& varied,
                 const skin::Spectrum& measured, const std::vector<double>& wavelengths,
                 const LightSource& light);

}  // namespace gonio
