// SPDX-License-Identifier: Apache-2.0
// Delta-M truncation (Wiscombe, J. Atmos. Sci. 34, 1977) and the addition theorem.
#include "reference/adding_doubling/redistribution.hpp"

#include <cmath>

#include "reference/phase_moments.hpp"

namespace gonio::reference {
namespace {

/// Associated Legendre functions sqrt((l - m)! / (l + m)!) P_l^m without their sign, one row for
/// each l below `terms`.
Eigen::MatrixXd legendre_functions(const Eigen::ArrayXd& cosine, int terms, int mode)
{
    Eigen::MatrixXd y = Eigen::MatrixXd::Zero(terms, cosine.size());
    if (mode >= terms) return y;
    const Eigen::ArrayXd sine = ((1 - cosine) * (1 + cosine)).sqrt();
    Eigen::ArrayXd first = Eigen::ArrayXd::Ones(cosine.size());
    for (int k = 1; k <= mode; ++k) first *= sine * std::sqrt((2.0 * k - 1) / (2.0 * k));
    y.row(mode) = first;
    const auto root = [&](int k) { return std::sqrt(double(k + mode) * double(k - mode)); };
    for (int l = mode; l + 1 < terms; ++l) {
        y.row(l + 1) = (2 * l + 1) * y.row(l).array() * cosine.transpose();
        if (l > mode) y.row(l + 1) -= root(l) * y.row(l - 1);
        y.row(l + 1) /= root(l + 1);
    }
    return y;
}

/// What the quadrature loses or wins is given back isotropically and symmetrically. It is as small
/// as the error of the highest moments.
void conserve_energy(const LocalDirections& directions, Redistribution& p)
{
    const Eigen::Index quadrature = directions.quadrature, size = directions.size();
    const Eigen::VectorXd weight =
        directions.root_weight.head(quadrature).array().square() /
        (2 * directions.n * directions.n * directions.cosine.head(quadrature));
    const Eigen::MatrixXd both = (p.forward + p.backward).topRows(quadrature);
    const Eigen::VectorXd missing = 1 - (both.transpose() * weight).array();
    const double mean = weight.dot(missing.head(quadrature)) / weight.sum();
    const Eigen::MatrixXd column = missing.replicate(1, size);
    const Eigen::MatrixXd share =
        (column + column.transpose()).array() / (2 * weight.sum()) - mean / (2 * weight.sum());
    p.forward += share;
    p.backward += share;
}

}  // namespace

// Wiscombe 1977, section 2, with a backward delta beside the forward one, so that g < 0 converges
// as g > 0 does: the first two moments beyond the `terms` are matched too.
TruncatedPhase truncate(const PhaseFunction& phase, const LocalDirections& directions)
{
    // More terms make the truncated peaks smaller, but the quadrature must integrate their
    // products.
    constexpr double terms_per_node = 1.25;
    const int terms =
        2 * static_cast<int>(std::lround(terms_per_node * double(directions.quadrature) / 2));
    const Eigen::VectorXd moments = legendre_moments(phase, terms + 2);
    const double forward = (moments(terms) + moments(terms + 1)) / 2;
    const double backward = (moments(terms) - moments(terms + 1)) / 2;
    Eigen::VectorXd rest = moments.head(terms);
    for (int l = 0; l < terms; ++l) {
        const double sign = l % 2 == 0 ? 1 : -1;
        rest(l) = (rest(l) - forward - sign * backward) / (1 - forward - backward);
    }
    return {forward, backward, rest};
}

Redistribution redistribute(const Layer& layer, const LocalDirections& directions, int mode)
{
    const TruncatedPhase phase = truncate(layer.phase, directions);
    const int terms = static_cast<int>(phase.moments.size());
    const Eigen::MatrixXd y = legendre_functions(directions.cosine, terms, mode);

    // The addition theorem. P_l^m(-mu) is P_l^m(mu) times the parity of l + m.
    Eigen::VectorXd scale = phase.moments;
    for (int l = 0; l < terms; ++l) scale(l) *= l + 0.5;
    const auto of_parity = [&](int parity) -> Eigen::MatrixXd {
        const auto rows = Eigen::seq((mode + parity) % 2, terms - 1, 2);
        const Eigen::MatrixXd part = y(rows, Eigen::all);
        return part.transpose() * scale(rows).asDiagonal() * part;
    };
    const Eigen::MatrixXd even = of_parity(0), odd = of_parity(1);
    Redistribution p{layer.mus * phase.rest(), layer.mus * phase.backward, even + odd, even - odd};
    if (mode == 0) conserve_energy(directions, p);
    return p;
}

}  // namespace gonio::reference
