// SPDX-License-Identifier: Apache-2.0
// Albedos lobe by lobe: orders rise, and maps are tried, until two orders agree in every cell.
#include "gonio/albedo.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "compute/idle_lobes.hpp"
#include "grid/angles.hpp"
#include "opencl/albedo_kernel.hpp"
#include "plan/interrupt.hpp"
#include "quadrature/spread.hpp"
#include "stopwatch.hpp"

namespace gonio {
namespace {

constexpr std::array orders{8, 16, 24, 32, 48, 64, 96, 128};
constexpr std::size_t lines_in_a_batch = 1 << 19;
/// What remains of rounding in the sum of a whole hemisphere, as a part of it.
constexpr double rounding = 2e-7;
/// From this spread on a lobe is so broad that nodes about the normal see all of it.
constexpr double broad = 0.1;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// All cells of one lobe.
class LobeIntegrals {
public:
    LobeIntegrals(const Device& device, const std::vector<Material>& materials,
                  const std::vector<AlbedoCell>& cells, Fixed fixed)
        : kernel_(device.state(), materials, fixed),
          cells_(cells),
          channels_(materials.front().channels()),
          previous_(3, planes(unknown)),
          value_(planes(0)),
          error_(planes(std::numeric_limits<double>::infinity()))
    {
        const unsigned traits = materials.front().lobes.front().traits();
        smoothness_ = {std::ranges::all_of(materials, &Material::isotropic),
                       (traits & KINKED) != 0};
        for (const Material& material : materials) spreads_.push_back(spread_of(material));
        const bool is_broad = std::ranges::all_of(
            spreads_, [](const Spread& s) { return std::min(s.x, s.y) > broad; });
        maps_ = {(traits & MIRRORED) != 0 ? map_mirror : map_half};
        if (is_broad) maps_.push_back(map_hemisphere);
    }

    /// seconds: as AlbedoOptions, for this lobe.
    void refine(double max_error, double seconds)
    {
        const Stopwatch since;
        for (std::size_t k = 0; k < orders.size(); ++k) {
            const double before = since.seconds();
            for (const quadrature_map map : maps_) {
                const auto wanted = unfinished(max_error);
                if (!wanted.empty()) order_ = orders[k];
                for (std::size_t first = 0; first < wanted.size();)
                    first = integrate(map, orders[k], wanted, first);
            }
            if (k == 0 || k + 1 == orders.size()) continue;
            // A rule has nodes in both angles.
            const double growth = double(orders[k + 1]) / orders[k], now = since.seconds();
            if (now + (now - before) * growth * growth > seconds) break;
        }
    }

    void add_to(Albedos& sum) const
    {
        for (std::size_t c = 0; c < sum.value.size(); ++c) {
            const std::size_t own = channels_ == 1 ? 0 : c;
            for (std::size_t k = 0; k < cells_.size(); ++k) {
                sum.value[c][k] += value_[own][k];
                sum.error[c][k] += error_[own][k];
            }
        }
        sum.order = std::max(sum.order, order_);
        sum.evaluated += evaluated_;
        sum.kernel_seconds += kernel_.seconds();
    }

private:
    using Planes = std::vector<std::vector<double>>;

    Planes planes(double filled) const
    {
        return Planes(channels_, std::vector(cells_.size(), filled));
    }

    std::vector<std::size_t> unfinished(double max_error) const
    {
        std::vector<std::size_t> wanted;
        for (std::size_t k = 0; k < cells_.size(); ++k)
            for (std::size_t c = 0; c < channels_; ++c)
                if (error_[c][k] > max_error * std::max(1.0, std::abs(value_[c][k]))) {
                    wanted.push_back(k);
                    break;
                }
        return wanted;
    }

    /// As many of the wanted cells as fit into a batch, from `first`; returns the first that did
    /// not.
    std::size_t integrate(quadrature_map map, int order, const std::vector<std::size_t>& wanted,
                          std::size_t first)
    {
        throw_if_interrupted();
        AlbedoBatch batch{{}, {}, map, order};
        std::size_t lines = 0, last = first;
        for (; last < wanted.size() && lines < lines_in_a_batch; ++last) {
            const AlbedoCell& cell = cells_[wanted[last]];
            batch.cells.push_back(cell);
            batch.lines.push_back(
                azimuth_nodes(map, cell.at, spreads_[cell.material], smoothness_, order));
            lines += batch.lines.back().size();
        }
        evaluated_ += lines * static_cast<std::size_t>(order);
        const Planes found = kernel_.integrate(batch);
        for (std::size_t k = first; k < last; ++k) judge(map, wanted[k], found, k - first);
        return last;
    }

    /// Takes a cell's values if they differ less from this map's lower order than what it has.
    void judge(quadrature_map map, std::size_t cell, const Planes& found, std::size_t at)
    {
        double estimate = 0, taken = 0;
        for (std::size_t c = 0; c < channels_; ++c) {
            estimate = std::max(estimate, std::abs(found[c][at] - previous_[map][c][cell]));
            if (std::isnan(previous_[map][c][cell])) estimate = unknown;
            taken = std::max(taken, error_[c][cell]);
        }
        for (std::size_t c = 0; c < channels_; ++c) {
            const double difference = std::abs(found[c][at] - previous_[map][c][cell]);
            previous_[map][c][cell] = found[c][at];
            if (!(estimate < taken)) continue;
            value_[c][cell] = found[c][at];
            error_[c][cell] = difference + rounding * std::abs(found[c][at]);
        }
    }

    AlbedoKernel kernel_;
    const std::vector<AlbedoCell>& cells_;
    std::size_t channels_;
    std::vector<Spread> spreads_;
    std::vector<quadrature_map> maps_;
    Smoothness smoothness_;
    std::vector<Planes> previous_;  // of each map
    Planes value_, error_;
    int order_ = 0;
    std::size_t evaluated_ = 0;
};

}  // namespace

glm::dvec3 unit_vector(const Incidence& at)
{
    const double sine = std::sqrt((1 - at.cosine) * (1 + at.cosine));
    return {sine * cosine_of_degrees(at.phi), sine * sine_of_degrees(at.phi), at.cosine};
}

Albedos integrate_albedos(const Device& device, const std::vector<Material>& materials,
                          const std::vector<AlbedoCell>& cells, const AlbedoOptions& options)
{
    Albedos sum;
    sum.value.assign(materials.front().channels(), std::vector<double>(cells.size()));
    sum.error = sum.value;
    const std::vector<std::size_t> lit = lobes_with_light(materials);
    double seconds = options.seconds;
    for (std::size_t k = 0; k < lit.size(); ++k) {
        std::vector<Material> alone;
        for (const Material& material : materials)
            alone.push_back({material.name, {material.lobes[lit[k]]}});
        LobeIntegrals integrals(device, alone, cells, options.fixed);
        const Stopwatch since;
        integrals.refine(options.max_error / static_cast<double>(lit.size()),
                         seconds / static_cast<double>(lit.size() - k));
        seconds -= since.seconds();
        integrals.add_to(sum);
    }
    return sum;
}

}  // namespace gonio
