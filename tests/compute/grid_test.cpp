// SPDX-License-Identifier: Apache-2.0
// Properties of every model of the registry on every grid: the same bits whatever the width, the
// tiles and the symmetries.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>

#include "gonio/compute.hpp"
#include "gonio/errors.hpp"
#include "verify/cases.hpp"

namespace gonio {
namespace {

/// Shared by all tests, so that programs stay built; closed before the process ends, while OpenCL
/// is still there.
class Devices : public testing::Environment {
public:
    static std::map<unsigned, Device>& opened()
    {
        static std::map<unsigned, Device> devices;
        return devices;
    }
    void TearDown() override { opened().clear(); }
};

const auto* const registered_devices =
    testing::AddGlobalTestEnvironment(std::make_unique<Devices>().release());

const Device& device_of_width(unsigned width)
{
    return Devices::opened().try_emplace(width, "", width).first->second;
}

std::vector<std::vector<float>> values(const Device& device, const Material& material,
                                       const Grid& grid, const ComputeOptions& options = {})
{
    std::vector<std::vector<float>> all(material.channels());
    const std::size_t length = grid.axes.back().values.size();
    compute_grid(
        device, material, Measure::brdf, grid,
        [&](const Rows<float>& rows) {
            for (std::size_t c = 0; c < all.size(); ++c)
                all[c].insert(all[c].end(), rows.planes[c], rows.planes[c] + rows.count * length);
        },
        options);
    return all;
}

/// Three channels wherever the model has any, so that channels are not mixed up.
Material coloured(const Model& model)
{
    Material material{std::string(model.id), {default_lobe(model.id)}};
    for (std::size_t k = 0; k < model.parameters.size(); ++k) {
        const Parameter& parameter = model.parameters[k];
        if (parameter.kind == Kind::table) {
            material.lobes[0].tables.resize(model.parameters.size());
            material.lobes[0].tables[k] = verification_residual(Spacing::merl, 3);
        }
        if (parameter.kind != Kind::color) continue;
        const double span = std::min(parameter.greatest, parameter.preset + 1) - parameter.least;
        material.lobes[0].values[k] = {parameter.least + 0.3 * span, parameter.least + 0.5 * span,
                                       parameter.least + 0.9 * span};
    }
    return material;
}

/// Grids have lengths that no vector divides, so that tails overlap.
class EveryModel : public testing::TestWithParam<Model> {
protected:
    static std::size_t place()
    {
        return static_cast<std::size_t>(find_model(GetParam().id) - models().data());
    }
    /// Of the model's width, 2 to 16.
    static const Device& device() { return device_of_width(2U << place() % 4); }
};

TEST_P(EveryModel, HasTheSameBitsAtEveryWidth)
{
    // Building a program takes longer than running it: each model at one width, on two kinds of
    // grids, and each kind at every width with one model or other.
    const Material material = coloured(GetParam());
    const Grid other = !material.isotropic() || place() / 4 % 2 == 0
                           ? anisotropic_grid(3, 2, 4, 37, Samples::centre)
                           : rusinkiewicz_grid(5, 6, 41, Samples::centre, Spacing::merl);
    std::vector<Grid> grids{other};
    if (material.isotropic()) {
        grids.push_back(isotropic_grid(5, 5, 37, Samples::centre));
        grids.push_back(isotropic_grid(4, 5, 23, Samples::node, 180));
    }
    for (const Grid& grid : grids)
        EXPECT_EQ(values(device_of_width(1), material, grid), values(device(), material, grid))
            << "grid of " << grid.axes[0].name;
}

TEST_P(EveryModel, HasTheSameBitsWithAndWithoutSymmetry)
{
    const Material material = coloured(GetParam());
    for (const std::size_t columns : {36U, 37U}) {
        const Grid grid = isotropic_grid(7, 7, columns, Samples::centre);
        EXPECT_EQ(values(device(), material, grid),
                  values(device(), material, grid, {.leave_out = false}));
    }
}

TEST_P(EveryModel, HasTheSameBitsInTiles)
{
    const Material material = coloured(GetParam());
    const Grid grid = isotropic_grid(9, 9, 33, Samples::centre);
    EXPECT_EQ(values(device(), material, grid),
              values(device(), material, grid, {.tile_bytes = 8000}));
}

TEST_P(EveryModel, GivesTheSameOnGridsAndAsPoints)
{
    const Material material = coloured(GetParam());
    const Grid grid = isotropic_grid(6, 7, 19, Samples::centre);
    std::vector<DirectionPair> pairs;
    for (const double i : grid.axes[0].values)
        for (const double o : grid.axes[1].values)
            for (const double phi : grid.axes[2].values) pairs.push_back({i, 0, o, phi});
    const auto on_grid = values(device(), material, grid);
    const auto as_points = compute_points(device(), material, Measure::brdf, pairs);
    for (std::size_t c = 0; c < on_grid.size(); ++c)
        for (std::size_t k = 0; k < pairs.size(); ++k)
            EXPECT_NEAR(on_grid[c][k], as_points[c][k], 1e-5F * std::abs(as_points[c][k]) + 1e-12F);
}

TEST_P(EveryModel, IsFiniteAndNotNegativeOnTheHorizon)
{
    const Material material = coloured(GetParam());
    for (const auto& channel : values(device(), material, isotropic_grid(4, 5, 17, Samples::node)))
        for (const float f : channel) {
            EXPECT_TRUE(std::isfinite(f));
            EXPECT_GE(f, 0);
        }
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryModel, testing::ValuesIn(models()),
                         [](const auto& model) { return std::string(model.param.id); });

TEST(Grids, KeepALimitOnTheHorizonAndClearAPole)
{
    const Grid grid = isotropic_grid(3, 3, 4, Samples::node, 180);
    const auto limit = [&](const char* model) {
        return values(device_of_width(1), {model, {default_lobe(model)}}, grid)[0].back();
    };
    EXPECT_FLOAT_EQ(limit("lambert"), static_cast<float>(0.5 / 3.14159265358979));
    // Two grazing directions at the mirror: Ward's 1/sqrt(cos cos) has no limit.
    EXPECT_EQ(limit("ward"), 0);
}

TEST(Grids, AddLobesWithTheirWeights)
{
    Material sum{"sum", {default_lobe("lambert"), default_lobe("ward")}};
    sum.lobes[1].set("weight", std::vector{0.25, 0.5, 1.0});
    const Grid grid = isotropic_grid(4, 4, 16, Samples::centre);
    const auto both = values(device_of_width(4), sum, grid);
    const auto first = values(device_of_width(4), {"a", {default_lobe("lambert")}}, grid)[0];
    const auto second = values(device_of_width(4), {"b", {default_lobe("ward")}}, grid)[0];
    const std::vector weights{0.25F, 0.5F, 1.0F};
    for (std::size_t c = 0; c < weights.size(); ++c)
        for (std::size_t k = 0; k < first.size(); ++k)
            EXPECT_FLOAT_EQ(both[c][k], first[k] + weights[c] * second[k]);
}

TEST(Grids, MultiplyTheCosineIn)
{
    const Material material{"x", {default_lobe("schlick")}};
    const Grid grid = isotropic_grid(4, 4, 16, Samples::centre);
    const Table brdf = compute_table(device_of_width(4), material, Measure::brdf, grid);
    const Table cosine = compute_table(device_of_width(4), material, Measure::brdf_cosine, grid);
    const GridVectors vectors(grid);
    for (std::size_t row = 0; row < 16; ++row)
        for (std::size_t k = 0; k < 16; ++k) {
            const double cos_i = vectors.at(row, k).first.z;
            EXPECT_NEAR(cosine.values[0][row * 16 + k], cos_i * brdf.values[0][row * 16 + k], 1e-6);
        }
}

TEST(Grids, RefuseAnAnisotropicMaterialWithoutAFrame)
{
    Material material{"steel", {default_lobe("ward")}};
    material.lobes[0].set("alpha_x", std::vector{0.05});
    EXPECT_THROW(values(device_of_width(1), material, isotropic_grid(2, 2, 4, Samples::centre)),
                 UsageError);
}

}  // namespace
}  // namespace gonio
