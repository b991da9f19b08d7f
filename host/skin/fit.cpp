// SPDX-License-Identifier: Apache-2.0
// Bounds by a change of variable, derivatives by differences.
#include "skin/fit.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <unsupported/Eigen/LevenbergMarquardt>

#include "gonio/errors.hpp"

namespace gonio {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double search_tolerance = 1e-3;  // of a reflectance; measurements repeat to 1e-2
constexpr double tolerance = 1e-4;         // of the one that is reported
constexpr double step = 1e-2;              // of the variables, rad
constexpr double near_limit = 1e-3;        // of a range
constexpr double margin = 0.05;            // rad: at the limit itself nothing would change with u

/// value = least + (greatest - least) sin^2 u, which every u keeps in range; fractions near 0,
/// which differ by factors, are spread as square roots.
double variable_of(const SkinParameter& parameter, double value)
{
    const double part = (value - parameter.least) / (parameter.greatest - parameter.least);
    const double u = std::asin(std::sqrt(part));
    return std::clamp(u, margin, std::numbers::pi / 2 - margin);
}

double value_of(const SkinParameter& parameter, double u)
{
    const double sine = std::sin(u);
    return std::clamp(std::lerp(parameter.least, parameter.greatest, sine * sine), parameter.least,
                      parameter.greatest);
}

/// Modelled minus measured reflectance, and how it changes with the variables.
struct Residual : Eigen::DenseFunctor<double> {
    Residual(const Skin& skin, const std::vector<std::size_t>& indices, const VectorXd& wanted,
             const std::vector<double>& at, const LightSource& source)
        : DenseFunctor(static_cast<int>(indices.size()), static_cast<int>(at.size())),
          start(skin),
          varied(indices),
          measured(wanted),
          wavelengths(at),
          light(source)
    {
    }

    Skin skin_at(const VectorXd& u) const
    {
        Skin skin = start;
        for (std::size_t k = 0; k < varied.size(); ++k) {
            const SkinParameter& parameter = skin.model().parameters[varied[k]];
            skin.set(parameter.name, value_of(parameter, u(static_cast<Index>(k))));
        }
        return skin;
    }

    int operator()(const VectorXd& u, VectorXd& residual) const
    {
        const auto spectrum = solve_skin({skin_at(u)}, wavelengths, light, search_tolerance)[0];
        residual = VectorXd::Map(spectrum.reflectance.data(), values()) - measured;
        return 0;
    }

    /// Forward differences; all spectra at once, so that they share their error.
    int df(const VectorXd& u, MatrixXd& derivative) const
    {
        std::vector<Skin> sets{skin_at(u)};
        for (Index k = 0; k < inputs(); ++k)
            sets.push_back(skin_at(u + step * VectorXd::Unit(inputs(), k)));
        const auto spectra = solve_skin(sets, wavelengths, light, search_tolerance);
        const auto reflectance = [&](Index k) {
            return VectorXd::Map(spectra[static_cast<std::size_t>(k)].reflectance.data(), values());
        };
        for (Index k = 0; k < inputs(); ++k)
            derivative.col(k) = (reflectance(k + 1) - reflectance(0)) / step;
        return 0;
    }

    Skin start;
    std::vector<std::size_t> varied;
    VectorXd measured;
    std::vector<double> wavelengths;
    LightSource light;
};

/// Standard errors from the spread of the residuals and the curvature at the minimum.
std::vector<FittedParameter> report(const Residual& problem, const VectorXd& u, double squares)
{
    MatrixXd derivative(problem.values(), problem.inputs());
    problem.df(u, derivative);
    const double variance = squares / std::max(problem.values() - problem.inputs(), 1);
    const MatrixXd curvature = derivative.transpose() * derivative;
    const Eigen::CompleteOrthogonalDecomposition<MatrixXd> inverse(curvature);
    const bool known = inverse.rank() == problem.inputs();
    const VectorXd spread = (variance * inverse.pseudoInverse().diagonal()).cwiseAbs().cwiseSqrt();
    std::vector<FittedParameter> all;
    for (Index k = 0; k < problem.inputs(); ++k) {
        const std::size_t index = problem.varied[static_cast<std::size_t>(k)];
        const SkinParameter& range = problem.start.model().parameters[index];
        const double width = range.greatest - range.least, value = value_of(range, u(k));
        const double slope = width * std::abs(std::sin(2 * u(k)));
        all.push_back({index, value,
                       known ? slope * spread(k) : std::numeric_limits<double>::infinity(),
                       std::min(value - range.least, range.greatest - value) < near_limit * width});
    }
    return all;
}

}  // namespace

SkinFit fit_skin(const Skin& start, const std::vector<std::size_t>& varied,
                 const skin::Spectrum& measured, const std::vector<double>& wavelengths,
                 const LightSource& light)
{
    if (varied.empty())
        throw UsageError(fmt::format("skin `{}` has no parameter to fit", start.model().id));
    if (wavelengths.size() <= varied.size())
        throw UsageError(fmt::format("{} wavelengths cannot tell {} parameters", wavelengths.size(),
                                     varied.size()));
    std::vector<double> wanted;
    for (const double wavelength : wavelengths) wanted.push_back(measured.at(wavelength));
    Residual problem(start, varied, VectorXd::Map(wanted.data(), static_cast<Index>(wanted.size())),
                     wavelengths, light);
    VectorXd u(problem.inputs());
    for (Index k = 0; k < u.size(); ++k) {
        const std::size_t index = varied[static_cast<std::size_t>(k)];
        u(k) = variable_of(start.model().parameters[index], start.values()[index]);
    }
    Eigen::LevenbergMarquardt<Residual> search(problem);
    search.setFtol(1e-4);
    search.setXtol(1e-3);
    search.setFactor(1);
    search.setMaxfev(40);
    search.minimize(u);

    const Skin skin = problem.skin_at(u);
    SkinFit fit{.skin = skin,
                .parameters = {},
                .spectrum = solve_skin({skin}, wavelengths, light, tolerance)[0],
                .measured = std::move(wanted)};
    const VectorXd left =
        VectorXd::Map(fit.spectrum.reflectance.data(), problem.values()) - problem.measured;
    fit.parameters = report(problem, u, left.squaredNorm());
    fit.mean_residual = left.cwiseAbs().mean();
    fit.rms_residual = std::sqrt(left.squaredNorm() / static_cast<double>(left.size()));
    fit.largest_residual = left.cwiseAbs().maxCoeff();
    return fit;
}

}  // namespace gonio
