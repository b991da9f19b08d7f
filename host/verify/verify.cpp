// SPDX-License-Identifier: Apache-2.0
// Compares a model on a device with its reference over random and extreme directions and
// parameters.
#include "verify/verify.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gonio/compute.hpp"
#include "verify/cases.hpp"

namespace gonio {
namespace {

/// Below the bound of relative error a value is compared with the maximum: float32 has 2^-24 of it,
/// and some.
constexpr double absolute_bound = 1e-9;
constexpr double reciprocity_bound = 1e-6;

struct Values {
    std::vector<float> device;
    std::vector<double> reference;
};

Values on_grid(const Device& device, const Material& material, Measure measure, const Grid& grid)
{
    Values values;
    const Reference reference = make_reference(material, measure);
    const std::size_t length = grid.axes.back().values.size();
    compute_grid(device, material, measure, grid, [&](const Rows<float>& rows) {
        values.device.insert(values.device.end(), rows.planes[0],
                             rows.planes[0] + rows.count * length);
    });
    const GridVectors vectors(grid);
    values.reference.reserve(values.device.size());
    for (std::size_t k = 0; k < values.device.size(); ++k) {
        const auto [l, v] = vectors.at(k / length, k % length);
        values.reference.push_back(l.z > 0 && v.z > 0 ? reference(l, v, 0) : 0);
    }
    return values;
}

Values on_points(const Device& device, const Material& material, Measure measure,
                 const std::vector<DirectionPair>& pairs)
{
    Values values{compute_points(device, material, measure, pairs)[0], {}};
    const Reference reference = make_reference(material, measure);
    for (const DirectionPair& pair : pairs) {
        const auto [l, v] = unit_vectors(pair);
        values.reference.push_back(reference(l, v, 0));
    }
    return values;
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
    const std::vector<DirectionPair> pairs = verification_pairs(quick ? 100 : 2000);
    double worst = -1;
    const auto judge = [&](const Material& material, const Values& values) {
        const Accuracy accuracy = compare(values.device, values.reference);
        const double bound = accuracy_bound(material);
        // Options of one model may have different bounds: the worst case is the one nearest to its
        // own.
        if (accuracy.relative / bound > worst) {
            worst = accuracy.relative / bound;
            verdict.bound = bound;
            verdict.worst = parameter_text(material.lobes[0]);
        }
        Accuracy scaled = accuracy;
        scaled.relative = 0;
        verdict.accuracy.merge(scaled);
        if (accuracy.relative / bound >= worst) {
            verdict.accuracy.relative = accuracy.relative;
            verdict.accuracy.device = accuracy.device;
            verdict.accuracy.reference = accuracy.reference;
        }
        verdict.negative += static_cast<std::size_t>(
            std::ranges::count_if(values.device, [](float f) { return f < 0; }));
    };
    for (const Material& material : verification_materials(model, quick ? 2 : 16)) {
        judge(material,
              on_grid(device, material, Measure::as_printed, verification_grid(material, density)));
        if (material.isotropic())
            judge(material,
                  on_grid(device, material, Measure::as_printed, verification_half_grid(density)));
        judge(material, on_points(device, material, Measure::as_printed, pairs));
        if ((material.lobes[0].traits() & ONE_WAY) == 0)
            verdict.reciprocity_defect = std::max(verdict.reciprocity_defect,
                                                  reciprocity_defect(device, material, pairs));
    }
    return verdict;
}

}  // namespace gonio
