// SPDX-License-Identifier: Apache-2.0
// Materials that can be sampled, each with lights, and the agreement of samples with a density.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "gonio/sampling.hpp"

namespace gonio::test {

struct SamplingCase {
    std::string name;
    Material material;
    double theta_i, phi_i;  ///< of the light, in degrees

    Incidence light() const;
};

/// Every combination of a model's options but for Fresnel's equations, which no sampler looks at.
std::vector<Lobe> sampled_variants(const Model& model);

/// A variant with its defaults, narrow, brushed and at its broadest, for lights from normal to
/// grazing.
std::vector<SamplingCase> sampling_cases(const Lobe& variant);

/// At both ends of the range of each number.
std::vector<SamplingCase> extreme_cases(const Lobe& variant);

/// The probability of a chi-squared as large as that of the samples' histogram, if they have this
/// density: over bins of theta_o and phi_o between the quantiles of other samples, the density's
/// integrals over them, and one bin below the horizon. Bins that expect fewer than five samples are
/// one.
double probability_of_histogram(
    const ViewerSamples& samples, const ViewerSamples& others, double phi_i,
    const std::function<std::vector<float>(const std::vector<glm::dvec3>&)>& density);

}  // namespace gonio::test
