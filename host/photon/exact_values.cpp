// SPDX-License-Identifier: Apache-2.0
// Quantities of layers by adding-doubling, without noise.
#include "photon/exact_values.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "photon/albedo_inversion.hpp"
#include "photon/bins.hpp"
#include "photon/mean_path.hpp"
#include "reference/adding_doubling.hpp"
#include "reference/gauss_legendre.hpp"
#include "reference/layered_brdf.hpp"
#include "stopwatch.hpp"

namespace gonio {
namespace {

using reference::AfterPart;
using std::numbers::pi;

/// A quantity's largest error if nobody asks for one, and what it is a part of.
struct Preset {
    double error;
    const char* of;
};

Preset preset_of(std::string_view quantity)
{
    if (quantity == "brdf") return {1e-3, "the largest value"};
    if (quantity.ends_with("_alpha")) return {1e-4, "the largest value"};
    if (quantity == "single_scattering_albedo") return {1e-6, "the albedo 1"};
    if (quantity == "mean_path") return {0, "each value"};
    return {1e-6, "the light"};
}

/// Whether a further solution is done in time.
class InTime {
public:
    explicit InTime(const LightJob& light) : seconds_(light.budget.seconds.value_or(INFINITY)) {}

    bool operator()(double growth)
    {
        const double now = since_.seconds(), before = std::exchange(before_, now);
        return now + growth * (now - before) <= seconds_;
    }

    /// Of the work, or of the time if that ends before.
    AfterPart told(const AfterPart& after_part) const
    {
        return [&](double part) {
            after_part(std::max(part, std::min(since_.seconds() / seconds_, 1.0)));
        };
    }

private:
    double seconds_, before_ = 0;
    Stopwatch since_;
};

/// The solution, and no values yet.
std::pair<reference::LayeredSolution, ExactValues> solve(const LightJob& light,
                                                         const reference::LightRequest& request,
                                                         const AfterPart& after_part)
{
    InTime time(light);
    auto solution = reference::solve_layers_to(light.medium, request, tolerance_of(light),
                                               time.told(after_part), std::ref(time));
    const double error = std::max(solution.error, solution.angular_error);
    ExactValues result{{}, solution.nodes, error};
    return {std::move(solution), std::move(result)};
}

ExactValues budget(const LightJob& light, const AfterPart& after_part)
{
    auto [solution, result] = solve(light, {.incidence = {light.light.incidence}}, after_part);
    for (const double part : parts_of(solution.under(light.light).budget))
        result.values.push_back({part, solution.error});
    return result;
}

double albedo(const reference::LightBudget& budget)
{
    return budget.specular + budget.diffuse_reflectance;
}

ExactValues mean_albedo(const LightJob& light, const AfterPart& after_part)
{
    auto [solution, result] = solve(light, {}, after_part);
    result.values = {{albedo(solution.diffuse.budget), solution.error}};
    return result;
}

ExactValues directional_albedo(const LightJob& light, const Axis& cosines,
                               const AfterPart& after_part)
{
    reference::LightRequest request;
    for (const double mu : cosines.values) request.incidence.push_back(std::acos(mu));
    auto [solution, result] = solve(light, request, after_part);
    for (const reference::Illumination& one : solution.collimated)
        result.values.push_back({albedo(one.budget), solution.error});
    return result;
}

ExactValues brdf(const LightJob& light, const std::vector<Axis>& axes, const AfterPart& after_part)
{
    const auto radians = [](const Axis& axis, double zero) {
        std::vector<double> angles;
        for (const double degrees : axis.values) angles.push_back((degrees - zero) * pi / 180);
        return angles;
    };
    InTime time(light);
    const auto brdf = reference::layered_brdf_to(
        light.medium, radians(axes[0], 0), radians(axes[1], 0), radians(axes[2], 180),
        tolerance_of(light), time.told(after_part), std::ref(time));
    ExactValues result{{}, brdf.nodes, brdf.error / std::ranges::max(brdf.values)};
    // Where next to nothing is scattered the sum over modes may fall below 0 within its error.
    for (const double value : brdf.values)
        result.values.push_back({std::max(value, 0.0), brdf.error});
    return result;
}

/// Means of a function of the angle to the normal over the solid angles of even bins, with a rule
/// in the cosine.
class BinMeans {
public:
    BinMeans(std::size_t bins, int points) : bins_(bins), rule_(reference::gauss_legendre(points))
    {
        for (std::size_t bin = 0; bin < bins; ++bin) {
            const double from = std::cos(edge(bin + 1)), to = std::cos(edge(bin));
            for (const double node : rule_.nodes)
                angles.push_back(std::acos(from + (to - from) * node));
        }
    }

    /// values: at the angles, from `first` on.
    double operator()(const Eigen::VectorXd& values, std::size_t first, std::size_t bin) const
    {
        return rule_.weights.dot(
            values.segment(static_cast<Eigen::Index>(first) +
                               static_cast<Eigen::Index>(bin) * rule_.weights.size(),
                           rule_.weights.size()));
    }

    std::vector<double> angles;

private:
    double edge(std::size_t k) const
    {
        return pi / 2 * static_cast<double>(k) / static_cast<double>(bins_);
    }

    std::size_t bins_;
    reference::QuadratureRule rule_;
};

/// Adds what leaves at one angle to its bin.
void add_narrow(std::vector<Fraction>& values, double flux, double sine)
{
    if (flux <= 0) return;
    const std::size_t count = values.size();
    const double part = std::asin(std::min(sine, 1.0)) / (pi / 2) * static_cast<double>(count);
    const std::size_t bin = std::min(static_cast<std::size_t>(part), count - 1);
    values[bin].mean += flux / solid_angle(bin, count);
}

ExactValues by_angle(const LightJob& light, const Axis& alpha, const AfterPart& after_part)
{
    const bool up = light.quantity->id == "reflectance_alpha";
    const std::size_t count = alpha.values.size();
    // The difference of two rules bounds the error of the means.
    const int points = static_cast<int>(std::clamp<std::size_t>(90 / count, 2, 12));
    const BinMeans rough(count, points), fine(count, points + 1);
    std::vector<double> exits = rough.angles;
    exits.insert(exits.end(), fine.angles.begin(), fine.angles.end());
    reference::LightRequest request{.incidence = {light.light.incidence}};
    (up ? request.exit_above : request.exit_below) = exits;
    auto [solution, result] = solve(light, request, after_part);
    const reference::Illumination& found = solution.under(light.light);
    const Eigen::VectorXd& intensity = up ? found.reflected : found.transmitted;
    const double error =
        intensity.size() == 0 ? 0 : solution.angular_error * intensity.cwiseAbs().maxCoeff();
    for (std::size_t bin = 0; bin < count; ++bin) {
        const double mean = fine(intensity, rough.angles.size(), bin);
        result.values.push_back({mean, error + std::abs(mean - rough(intensity, 0, bin))});
    }
    if (light.light.beam == Beam::diffuse) return result;
    const double sine = std::sin(light.light.incidence);
    const LayeredMedium& medium = light.medium;
    if (up)
        add_narrow(result.values, found.narrow_reflected, sine);
    else
        add_narrow(result.values, found.narrow_transmitted, sine * medium.n_above / medium.n_below);
    return result;
}

}  // namespace

double tolerance_of(const LightJob& light)
{
    const double preset = light.budget.seconds ? 0 : preset_of(light.quantity->id).error;
    return light.budget.max_error.value_or(preset);
}

const char* error_of(const LightJob& light)
{
    return preset_of(light.quantity->id).of;
}

ExactValues exact_values(const LightJob& light, const std::vector<Axis>& axes,
                         const AfterPart& after_part)
{
    const std::string_view id = light.quantity->id;
    if (id == "brdf") return brdf(light, axes, after_part);
    if (id == "directional_albedo") return directional_albedo(light, axes.front(), after_part);
    if (id == "mean_albedo") return mean_albedo(light, after_part);
    if (id == "single_scattering_albedo") return invert_albedos(light, axes.front(), after_part);
    if (id == "mean_path") return mean_paths(light, after_part);
    if (id == "light_budget") return budget(light, after_part);
    return by_angle(light, axes.front(), after_part);
}

}  // namespace gonio
