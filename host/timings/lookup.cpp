// SPDX-License-Identifier: Apache-2.0
// A BRDF evaluated, against one read from tables of it.
#include <fmt/format.h>
#include <half.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "gonio/compute.hpp"
#include "output/grid_coordinates.hpp"
#include "output/lookup.hpp"
#include "timings/relative_error.hpp"
#include "timings/sections.hpp"

namespace gonio {
namespace {

constexpr double most_theta = 85;  // beyond, grazing light decides every error

/// Even in the cosines and in the azimuth.
std::vector<DirectionPair> random_pairs(std::size_t count)
{
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> cosine(std::cos(most_theta * std::numbers::pi / 180), 1),
        azimuth(0, 360);
    const auto theta = [&] { return std::acos(cosine(random)) * 180 / std::numbers::pi; };
    std::vector<DirectionPair> pairs(count);
    for (DirectionPair& pair : pairs) pair = {theta(), 0, theta(), azimuth(random)};
    return pairs;
}

/// One BRDF at random pairs of directions.
class Subject {
public:
    Subject(const BenchRun& run, std::string name, Lobe lobe)
        : run_(run),
          material_{std::move(name), {std::move(lobe)}},
          pairs_(random_pairs(run.quick ? 4096 : 16384))
    {
        const Reference f = make_reference(material_, Measure::brdf);
        for (const DirectionPair& pair : pairs_) {
            const auto [l, v] = unit_vectors(pair);
            right_.push_back(f(l, v, 0));
        }
    }

    void evaluate()
    {
        add("reference, one core", "double",
            [this, f = make_reference(material_, Measure::brdf)](std::vector<double>& found) {
                for (std::size_t k = 0; k < pairs_.size(); ++k) {
                    const auto [l, v] = unit_vectors(pairs_[k]);
                    found[k] = f(l, v, 0);
                }
            });
        add("device, list of pairs", "float32", [this](std::vector<double>& found) {
            const auto values = compute_points(run_.device, material_, Measure::brdf, pairs_);
            found.assign(values[0].begin(), values[0].end());
        });
    }

    void look_up(std::size_t size)
    {
        const auto table = std::make_shared<Table>(
            compute_table(run_.device, material_, Measure::brdf,
                          isotropic_grid(size, size, 2 * size, Samples::node, 180)));
        look_up(table, size, "float32");
        const auto rounded = std::make_shared<Table>(*table);
        for (double& value : rounded->values[0])
            value = static_cast<double>(static_cast<float>(half(static_cast<float>(value))));
        look_up(rounded, size, "half");
    }

    void measure(BenchPlot& plot) { time_in_turn(plot, std::move(candidates_), run_.rounds()); }

private:
    void look_up(const std::shared_ptr<const Table>& table, std::size_t size,
                 std::string_view format)
    {
        constexpr std::array names{"nearest", "linear", "cubic"};
        for (const Interpolation how :
             {Interpolation::nearest, Interpolation::linear, Interpolation::cubic})
            add(fmt::format("{}, {}", names[static_cast<std::size_t>(how)], format),
                fmt::format("{0}x{0}x{1}", size, 2 * size),
                [this, table, lookup = Lookup(*table, how)](std::vector<double>& found) {
                    for (std::size_t k = 0; k < pairs_.size(); ++k)
                        found[k] = lookup.at(grid_coordinates(GridKind::isotropic, pairs_[k]))[0];
                });
    }

    /// work: fills in the values at all pairs.
    void add(const std::string& how, const std::string& label,
             const std::function<void(std::vector<double>&)>& work)
    {
        std::vector<double> found(pairs_.size());
        work(found);
        const double error = relative_error(found, right_);
        const auto nanoseconds_each = [work, found]() mutable {
            return seconds_on_the_wall([&] { work(found); }) * 1e9 / double(found.size());
        };
        BenchPoint point{how, label, {}, exactly(error)};
        candidates_.push_back({std::move(point), nanoseconds_each});
    }

    const BenchRun& run_;
    Material material_;
    std::vector<DirectionPair> pairs_;
    std::vector<double> right_;
    std::vector<Candidate> candidates_;
};

Lobe glossy(double alpha)
{
    Lobe lobe = default_lobe("ggx");
    lobe.set("alpha", std::vector{alpha});
    return lobe;
}

BenchPlot look_up(const BenchRun& run, const char* id, const char* title, const Lobe& lobe)
{
    BenchPlot plot{
        id, fmt::format("{}: evaluated, or read from a table", title),
        fmt::format("Random pairs of directions up to {} degrees. Tables are read on one "
                    "core of the host, in double, nodes on their axes; half: values "
                    "rounded as in a half EXR. The list of pairs goes to the device "
                    "and back.",
                    most_theta),
        "ns per value", "root mean square error, relative"};
    std::vector<std::size_t> sizes{8, 16, 32};
    if (!run.quick) sizes.insert(sizes.end(), {64, 128});
    Subject subject(run, id, lobe);
    run.step(fmt::format("{}: evaluated", id));
    subject.evaluate();
    for (const std::size_t size : sizes) {
        run.step(fmt::format("{}: {} samples an angle", id, size));
        subject.look_up(size);
    }
    subject.measure(plot);
    mark_best(plot);
    return plot;
}

}  // namespace

BenchPlot bench_lookup(const BenchRun& run)
{
    return look_up(run, "lookup", "GGX, alpha 0.2", glossy(0.2));
}

BenchPlot bench_lookup_sharp(const BenchRun& run)
{
    return look_up(run, "lookup-sharp", "GGX, alpha 0.05", glossy(0.05));
}

BenchPlot bench_lookup_diffuse(const BenchRun& run)
{
    return look_up(run, "lookup-diffuse", "Oren-Nayar", default_lobe("oren_nayar"));
}

}  // namespace gonio
