// SPDX-License-Identifier: Apache-2.0
// Compares a model on a device with its reference over random and extreme directions and
// parameters.
#include "verify/verify.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "gonio/compute.hpp"
#include "verify/cases.hpp"

namespace gonio {
namespace {

/// Below the bound of relative error a value is compared with the maximum: float32 has 2^-24 of it,
/// and some.
constexpr double absolute_bound = 1e-9;
constexpr double reciprocity_bound = 1e-6;

using Vectors = std::vector<std::pair<glm::dvec3, glm::dvec3>>;

/// Directions, given as a kernel and as a reference wants them.
struct GridCases {
    explicit GridCases(Grid cells) : grid(std::move(cells))
    {
        const GridVectors table(grid);
        const std::size_t length = grid.axes.back().values.size();
        std::size_t count = 1;
        for (const Axis& axis : grid.axes) count *= axis.values.size();
        for (std::size_t k = 0; k < count; ++k) vectors.push_back(table.at(k / length, k % length));
    }
    Grid grid;
    Vectors vectors;
};

struct PointCases {
    explicit PointCases(std::size_t count) : pairs(verification_pairs(count))
    {
        for (const DirectionPair& pair : pairs) vectors.push_back(unit_vectors(pair));
    }
    std::vector<DirectionPair> pairs;
    Vectors vectors;
};

std::vector<float> values_of(const Device& device, const Material& material, const Grid& grid)
{
    std::vector<float> values;
    const std::size_t length = grid.axes.back().values.size();
    compute_grid(device, material, Measure::as_printed, grid, [&](const Rows<float>& rows) {
        values.insert(values.end(), rows.planes[0], rows.planes[0] + rows.count * length);
    });
    return values;
}

std::vector<float> values_of(const Device& device, const Material& material,
                             const std::vector<DirectionPair>& pairs)
{
    return compute_points(device, material, Measure::as_printed, pairs)[0];
}

Accuracy accuracy_of(const std::vector<float>& values, const Material& material,
                     const Vectors& vectors)
{
    const Reference reference = make_reference(material, Measure::as_printed);
    std::vector<double> expected;
    for (const auto& [l, v] : vectors)
        expected.push_back(l.z > 0 && v.z > 0 ? reference(l, v, 0) : 0);
    const double rounding = direction_rounding(material);
    return compare(values, expected, [&](std::size_t k) {
        const auto& [l, v] = vectors[k];
        return l.z > 0 && v.z > 0 ? sensitivity(reference, l, v, 0, rounding) : 0;
    });
}

/// Of the BRDF: |f(l, v) - f(v, l)| as a fraction of the greatest f.
double reciprocity_defect(const Device& device, const Material& material,
                          std::vector<DirectionPair> pairs)
{
    const bool is_value = (material.lobes[0].traits() & VALUE) != 0;
    const Measure measure = is_value ? Measure::brdf : Measure::as_printed;
    const std::vector<float> forward = compute_points(device, material, measure, pairs)[0];
    for (DirectionPair& pair : pairs) {
        std::swap(pair.theta_i, pair.theta_o);
        std::swap(pair.phi_i, pair.phi_o);
    }
    const std::vector<float> backward = compute_points(device, material, measure, pairs)[0];
    float defect = 0, maximum = std::numeric_limits<float>::min();
    for (std::size_t k = 0; k < forward.size(); ++k) {
        defect = std::max(defect, std::abs(forward[k] - backward[k]));
        maximum = std::max(maximum, forward[k]);
    }
    return static_cast<double>(defect / maximum);
}

bool has_options_of(const Lobe& lobe, const Lobe& other)
{
    for (std::size_t k = 0; k < lobe.values.size(); ++k)
        if (lobe.model->parameters[k].kind == Kind::choice && lobe.values[k] != other.values[k])
            return false;
    return true;
}

}  // namespace

bool Verdict::passed() const
{
    return accuracy.relative <= bound && accuracy.absolute <= absolute_bound &&
           accuracy.not_finite == 0 && negative == 0 && reciprocity_defect <= reciprocity_bound;
}

Verdict verify_model(const Device& device, const Model& model, bool quick)
{
    Verdict verdict{std::string(model.id), {}, 0, 0, 0, {}};
    const std::size_t density = quick ? 2 : 8;
    const PointCases points(quick ? 100 : 2000);
    const GridCases half_grid(verification_half_grid(density));
    std::map<GridKind, GridCases> grids;
    double worst = -1;
    const auto judge = [&](const Material& material, const std::vector<float>& values,
                           const Vectors& vectors) {
        Accuracy accuracy = accuracy_of(values, material, vectors);
        const double bound = accuracy_bound(material);
        // Options of one model may have different bounds: the worst case is the one nearest to its
        // own.
        if (accuracy.relative / bound > worst) {
            worst = accuracy.relative / bound;
            verdict.bound = bound;
            verdict.worst = parameter_text(material.lobes[0]);
            verdict.accuracy.relative = 0;
        } else {
            accuracy.relative = 0;
        }
        verdict.accuracy.merge(accuracy);
        verdict.negative +=
            static_cast<std::size_t>(std::ranges::count_if(values, [](float f) { return f < 0; }));
    };
    const Lobe preset = default_lobe(model.id);
    for (const Material& material : verification_materials(model, quick)) {
        judge(material, values_of(device, material, points.pairs), points.vectors);
        if ((material.lobes[0].traits() & ONE_WAY) == 0)
            verdict.reciprocity_defect = std::max(
                verdict.reciprocity_defect, reciprocity_defect(device, material, points.pairs));
        // Programs take longer to build than to run, and all options see the same of a grid.
        if (quick && !has_options_of(material.lobes[0], preset)) continue;
        const GridKind kind = material.isotropic() ? GridKind::isotropic : GridKind::anisotropic;
        const GridCases& grid =
            grids.try_emplace(kind, verification_grid(material, density)).first->second;
        judge(material, values_of(device, material, grid.grid), grid.vectors);
        if (kind == GridKind::isotropic)
            judge(material, values_of(device, material, half_grid.grid), half_grid.vectors);
    }
    return verdict;
}

}  // namespace gonio
