// SPDX-License-Identifier: Apache-2.0
// The least squares problem, for Eigen's solver.
#include "compress/fit.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <numbers>
#include <random>
#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>

#include "gonio/errors.hpp"
#include "gonio/grid.hpp"

namespace gonio {
namespace {

constexpr std::size_t most_samples = 4000;
constexpr double least_alpha = 1e-3;

struct Sample {
    glm::dvec3 l, v;
    std::vector<double> f;  ///< a channel each
};

std::vector<Sample> samples_of(const Table& table)
{
    const GridVectors vectors({GridKind::rusinkiewicz, table.header.axes});
    const std::size_t cells = table.header.cells(), length = table.header.row_length();
    const std::size_t step = std::max<std::size_t>(1, cells / most_samples);
    std::mt19937_64 random(20090101);
    std::vector<Sample> samples;
    for (std::size_t first = 0; first < cells; first += step) {
        const std::size_t cell = std::min(cells - 1, first + random() % step);
        const auto [l, v] = vectors.at(cell / length, cell % length);
        if (!(l.z > 0) || !(v.z > 0)) continue;
        Sample sample{l, v, {}};
        for (const auto& plane : table.values) sample.f.push_back(plane[cell]);
        if (std::ranges::all_of(sample.f, [](double f) { return std::isfinite(f) && f >= 0; }))
            samples.push_back(sample);
    }
    return samples;
}

Lobe lobe_with(double alpha, const std::vector<double>& k_d, const std::vector<double>& k_s)
{
    Lobe lobe = default_lobe("lebedev");
    const auto bounded = [](std::vector<double> shares) {
        for (double& share : shares) share = std::clamp(share, 1e-9, 1.0);
        return shares;
    };
    lobe.set("alpha", std::vector{std::clamp(alpha, least_alpha, 1.0)});
    lobe.set("k_d", bounded(k_d));
    lobe.set("k_s", bounded(k_s));
    return lobe;
}

/// Unknowns: log alpha, then for each channel the square roots of k_d and k_s, which keeps these
/// positive.
class Misfit {
public:
    using Scalar = double;
    enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };
    using InputType = Eigen::VectorXd;
    using ValueType = Eigen::VectorXd;
    using JacobianType = Eigen::MatrixXd;

    explicit Misfit(const std::vector<Sample>& samples) : samples_(&samples) {}

    int inputs() const { return static_cast<int>(1 + 2 * channels()); }
    int values() const { return static_cast<int>(samples_->size() * channels()); }

    int operator()(const InputType& x, ValueType& misfit) const
    {
        const Lobe unit = lobe_with(std::exp(x[0]), {0}, {1});
        const Reference lobe = make_reference({"", {unit}}, Measure::brdf, Parameters::as_given);
        Eigen::Index row = 0;
        for (const Sample& sample : *samples_) {
            const double specular = lobe(sample.l, sample.v, 0);
            for (std::size_t c = 0; c < channels(); ++c) {
                const auto at = static_cast<Eigen::Index>(1 + 2 * c);
                const double f =
                    x[at] * x[at] / std::numbers::pi + x[at + 1] * x[at + 1] * specular;
                misfit[row++] = std::cbrt(f) - std::cbrt(sample.f[c]);
            }
        }
        return 0;
    }

    Lobe lobe_at(const InputType& x) const
    {
        std::vector<double> k_d, k_s;
        for (Eigen::Index at = 1; at < x.size(); at += 2) {
            k_d.push_back(x[at] * x[at]);
            k_s.push_back(x[at + 1] * x[at + 1]);
        }
        return lobe_with(std::exp(x[0]), k_d, k_s);
    }

private:
    std::size_t channels() const { return samples_->front().f.size(); }

    const std::vector<Sample>* samples_;
};

}  // namespace

Lobe fit_lobe(const Table& table)
{
    const std::vector<Sample> samples = samples_of(table);
    const Misfit misfit(samples);
    if (samples.empty()) throw RunError("the table has no value above the horizon");
    Lobe best = default_lobe("lebedev");
    double least = -1;
    for (const double alpha : {0.02, 0.1, 0.4}) {
        Eigen::VectorXd x = Eigen::VectorXd::Constant(misfit.inputs(), std::sqrt(0.2));
        x[0] = std::log(alpha);
        Eigen::NumericalDiff<Misfit> problem(misfit);
        Eigen::LevenbergMarquardt<Eigen::NumericalDiff<Misfit>> solver(problem);
        solver.parameters.maxfev = Eigen::Index{40} * misfit.inputs();
        solver.minimize(x);
        if (least >= 0 && !(solver.fnorm < least)) continue;
        least = solver.fnorm;
        best = misfit.lobe_at(x);
    }
    return best;
}

}  // namespace gonio
