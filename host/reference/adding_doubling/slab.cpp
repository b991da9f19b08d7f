// SPDX-License-Identifier: Apache-2.0
// Doubling (van de Hulst 1963; Hansen, Astrophys. J. 155, 1969).
#include "reference/adding_doubling/slab.hpp"

#include <algorithm>
#include <cmath>

#include "reference/adding_doubling/redistribution.hpp"

namespace gonio::reference {
namespace {

/// (1 - exp(-x)) / x for x >= 0.
double mean_decay(double x)
{
    return x == 0 ? 1 : -std::expm1(-x) / x;
}

/// Doubling of one layer's scattering from a thin start to any thickness.
class Doubling {
public:
    Doubling(const Layer& layer, const LocalDirections& directions, int mode);
    Slab solve(double thickness, const std::function<void()>& after_doubling) const;

private:
    Slab unscattered(double thickness) const;
    Slab scattered_once(double thickness) const;
    Slab thin(double thickness) const;
    Slab doubled(const Slab& half, double thickness) const;

    Eigen::Index quadrature_;
    bool clear_;
    double thinnest_;                     ///< cm
    Eigen::ArrayXd extinction_, retro_;   ///< per depth along each direction, 1/cm
    Eigen::MatrixXd forward_, backward_;  ///< scattered flux per depth, 1/cm
};

Doubling::Doubling(const Layer& layer, const LocalDirections& directions, int mode)
    : quadrature_(directions.quadrature), clear_(layer.mus == 0)
{
    const Redistribution p = redistribute(layer, directions, mode);
    extinction_ = (layer.mua + p.scattering + p.retro) / directions.cosine;
    retro_ = (mode % 2 == 0 ? 1 : -1) * p.retro / directions.cosine;  // to the opposite azimuth
    // The flux per q that one unit of flux scatters per depth: mus p(mu, mu') / (2 n^2 mu mu').
    const Eigen::VectorXd root =
        directions.root_weight.array() / (directions.n * directions.cosine);
    forward_ = p.scattering / 2 * root.asDiagonal() * p.forward * root.asDiagonal();
    backward_ = p.scattering / 2 * root.asDiagonal() * p.backward * root.asDiagonal();
    // The error of the start is of third order in this ratio. Where nothing absorbs, 1 / 1024 would
    // lose 1e-14 of each scattered unit and 1 / 4096 loses no more than rounding.
    constexpr double thin_against_grazing = 1.0 / 4096;
    thinnest_ = thin_against_grazing / extinction_.head(quadrature_).maxCoeff();
}

/// Light that keeps its line: two opposite streams that decay and scatter into each other (Kubelka,
/// J. Opt. Soc. Am. 38, 1948), with exp(-gamma) taken out of the hyperbolic functions.
Slab Doubling::unscattered(double thickness) const
{
    const Eigen::ArrayXd a = extinction_ * thickness, b = retro_ * thickness;
    const Eigen::ArrayXd gamma = (a - b).sqrt() * (a + b).sqrt();
    const Eigen::ArrayXd decay = gamma.unaryExpr([](double x) { return std::exp(-x); });
    const Eigen::ArrayXd sinh = (2 * gamma).unaryExpr(&mean_decay);  // over gamma
    const Eigen::ArrayXd cosh = (1 + decay.square()) / 2;
    const Eigen::ArrayXd all = cosh + a * sinh;
    return {specular(b * sinh / all, quadrature_), specular(decay / all, quadrature_)};
}

/// One smooth scattering, integrated over depth in closed form.
Slab Doubling::scattered_once(double thickness) const
{
    Slab slab = unscattered(thickness);
    const Eigen::Index size = extinction_.size();
    slab.reflection.kernel.resize(size, size);
    slab.transmission.kernel.resize(size, size);
    for (Eigen::Index j = 0; j < size; ++j) {
        for (Eigen::Index i = 0; i < size; ++i) {
            const double there = extinction_(j) * thickness, back = extinction_(i) * thickness;
            slab.reflection.kernel(i, j) = backward_(i, j) * thickness * mean_decay(there + back);
            slab.transmission.kernel(i, j) = forward_(i, j) * thickness *
                                             std::exp(-std::min(there, back)) *
                                             mean_decay(std::abs(there - back));
        }
    }
    return slab;
}

/// Scattering more than once within a part is an error of first and second order in the part's
/// thickness; three divisions of the slab cancel both (Romberg).
Slab Doubling::thin(double thickness) const
{
    Slab slab = unscattered(thickness);
    const auto add = [&](double factor, const Slab& part) {
        slab.reflection.kernel += factor * part.reflection.kernel;
        slab.transmission.kernel += factor * part.transmission.kernel;
    };
    add(1.0 / 3, scattered_once(thickness));
    add(-2, doubled(scattered_once(thickness / 2), thickness));
    add(8.0 / 3, doubled(doubled(scattered_once(thickness / 4), thickness / 2), thickness));
    return slab;
}

/// Two equal slabs, one above the other. The diagonals are set afresh, as they would double their
/// rounding each time.
Slab Doubling::doubled(const Slab& half, double thickness) const
{
    const auto& [r, t] = half;
    const LightOperator between = after_round_trips(symmetric_product(r, r), t);
    Slab whole{r + symmetric_product(t, r * between), symmetric_product(t, between)};
    const Slab line = unscattered(thickness);
    whole.reflection.diagonal = line.reflection.diagonal;
    whole.transmission.diagonal = line.transmission.diagonal;
    return whole;
}

Slab Doubling::solve(double thickness, const std::function<void()>& after_doubling) const
{
    if (clear_) return unscattered(thickness);
    const double levels = std::max(0.0, std::ceil(std::log2(thickness / thinnest_)));
    double part = thickness / std::exp2(levels);
    Slab slab = thin(part);
    while (part < thickness) {
        constexpr double nothing = 1e-18;
        const LightOperator& t = slab.transmission;
        if (t.kernel.cwiseAbs().maxCoeff() + t.diagonal.maxCoeff() < nothing) {
            return {slab.reflection, unscattered(thickness).transmission};
        }
        part *= 2;
        slab = doubled(slab, part);
        after_doubling();
    }
    return slab;
}

}  // namespace

Slab solve_slab(const Layer& layer, const LocalDirections& directions, int mode)
{
    return solve_slab_by_steps(layer, directions, mode, [] {});
}

Slab solve_slab_by_steps(const Layer& layer, const LocalDirections& directions, int mode,
                         const std::function<void()>& after_doubling)
{
    constexpr double infinite =
        1e30;  // cm: light that scatters only has gone back by then, to 1 / optical depth
    return Doubling(layer, directions, mode).solve(std::min(layer.d, infinite), after_doubling);
}

}  // namespace gonio::reference
