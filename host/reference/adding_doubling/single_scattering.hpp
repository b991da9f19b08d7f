// SPDX-License-Identifier: Apache-2.0
// What truncation takes from light that is scattered once.
#pragma once

#include "gonio/layers.hpp"
#include "reference/adding_doubling/directions.hpp"

namespace gonio::reference {

/// The BRDF of light scattered once with the phase functions of the layers less that with their
/// truncated ones, both behind the truncated ones' extinction. Angles in rad; the azimuth is 0 on
/// the side of the mirror direction. Nakajima and Tanaka, J. Quant. Spectrosc. Radiat. Transfer 40,
/// 1988 (TMS), for layers with boundaries that light crosses straight in and straight out. To add
/// it makes the BRDF converge where a phase function has a peak.
class SingleScattering {
public:
    SingleScattering(const LayeredMedium& medium, const Directions& directions);

    double operator()(double theta_i, double theta_o, double delta_phi) const;

private:
    struct Scatterer {
        const Layer* layer;
        double extinction;        ///< truncated, 1/cm
        double smooth;            ///< coefficient of the truncated phase function, 1/cm
        Eigen::VectorXd moments;  ///< of it
    };
    double difference(const Scatterer& layer, double cosine) const;

    double n_above_;
    std::vector<Scatterer> layers_;
};

}  // namespace gonio::reference
