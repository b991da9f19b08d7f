// SPDX-License-Identifier: Apache-2.0
// Samplers of every model that has one: the samples' histogram against their pdf, the mean of their
// weights against quadrature, the same bits at every width, and extremes.
#include "gonio/sampling.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "compute/shared_device.hpp"
#include "gonio/errors.hpp"
#include "reference/reference_fixtures.hpp"
#include "sampling/sampling_fixtures.hpp"

namespace gonio::test {
namespace {

constexpr std::size_t count = 100000;

std::vector<Model> sampled_models()
{
    std::vector<Model> all;
    for (const Model& model : models())
        if ((model.traits & SAMPLED) != 0) all.push_back(model);
    return all;
}

/// Of all histograms together: where all is right, one run in a hundred with another seed would
/// fail. Each has Sidak's share of it (J. Am. Stat. Assoc. 62, 1967).
double level()
{
    constexpr double significance = 0.01;
    std::size_t histograms = 1;  // of the mixture
    for (const Model& model : sampled_models())
        for (const Lobe& variant : sampled_variants(model))
            histograms += sampling_cases(variant).size();
    return -std::expm1(std::log1p(-significance) / static_cast<double>(histograms));
}

class SamplingOfSums : public test::SharedDevice {
protected:
    static void expect_density(const SamplingCase& test)
    {
        const ViewerSamples samples =
            sample_viewers(*device(), test.material, test.light(), {1, 0, count});
        const ViewerSamples others =
            sample_viewers(*device(), test.material, test.light(), {2, 0, 10000});
        const auto density = [&](const std::vector<glm::dvec3>& viewers) {
            return sampling_density(*device(), test.material, test.light(), viewers);
        };
        EXPECT_GT(probability_of_histogram(samples, others, test.phi_i, density), level())
            << test.name;
    }
};

class Sampling : public SamplingOfSums, public testing::WithParamInterface<Model> {};

TEST_P(Sampling, HistogramsAgreeWithTheDensity)
{
    for (const Lobe& variant : sampled_variants(GetParam()))
        for (const SamplingCase& test : sampling_cases(variant)) expect_density(test);
}

/// White light from everywhere: what a renderer sees is the directional albedo.
TEST_P(Sampling, WeightsAddUpToTheAlbedo)
{
    for (const Lobe& variant : sampled_variants(GetParam())) {
        const std::vector<SamplingCase> cases = sampling_cases(variant);
        std::vector<Material> materials;
        std::vector<AlbedoCell> cells;
        for (const SamplingCase& test : cases) {
            cells.push_back({materials.size(), test.light()});
            materials.push_back(test.material);
        }
        const Albedos albedos = integrate_albedos(*device(), materials, cells, {.max_error = 1e-5});
        for (std::size_t k = 0; k < cases.size(); ++k) {
            const ViewerSamples samples =
                sample_viewers(*device(), cases[k].material, cases[k].light(), {3, 0, count});
            double sum = 0, squares = 0;
            for (const float weight : samples.weight[0]) {
                sum += static_cast<double>(weight);
                squares += static_cast<double>(weight) * static_cast<double>(weight);
            }
            const double mean = sum / count;
            const double error =
                std::sqrt(std::max(squares / count - mean * mean, 0.0) / (count - 1));
            EXPECT_NEAR(mean, albedos.value[0][k],
                        5 * error + albedos.error[0][k] + 1e-5 * std::abs(mean))
                << cases[k].name << ", standard error " << error;
        }
    }
}

TEST_P(Sampling, ExtremesAreFinite)
{
    for (const Lobe& variant : sampled_variants(GetParam()))
        for (const SamplingCase& test : extreme_cases(variant)) {
            const ViewerSamples samples =
                sample_viewers(*device(), test.material, test.light(), {4, 0, 4096});
            std::size_t wrong = 0;
            for (std::size_t k = 0; k < samples.pdf.size(); ++k) {
                const glm::dvec3 v = samples.viewer[k];
                const float pdf = samples.pdf[k], weight = samples.weight[0][k];
                const bool is_unit = std::abs(glm::dot(v, v) - 1) < 1e-5;
                const bool is_finite = std::isfinite(pdf) && std::isfinite(weight);
                const bool is_right = v.z > 0 ? pdf > 0 && weight >= 0 : pdf == 0 && weight == 0;
                wrong += is_unit && is_finite && is_right ? 0 : 1;
            }
            EXPECT_EQ(wrong, 0U) << test.name;
        }
}

INSTANTIATE_TEST_SUITE_P(Registry, Sampling, testing::ValuesIn(sampled_models()),
                         [](const auto& model) { return std::string(model.param.id); });

/// All that can be sampled, in one sum.
SamplingCase mixture()
{
    Material sum{"mixture", {}};
    for (const Model& model : sampled_models()) sum.lobes.push_back(default_lobe(model.id));
    sum.lobes.back().set("n_u", std::vector{10.0});
    sum.lobes.front().set("rho", std::vector{0.9, 0.5, 0.1});
    return {"mixture", sum, 55, 70};
}

TEST_F(SamplingOfSums, HistogramAgreesWithTheDensity)
{
    expect_density(mixture());
}

TEST_F(SamplingOfSums, AreTheSameAtEveryWidthAndFromEveryFirst)
{
    const SamplingCase test = mixture();
    const std::uint64_t first = (std::uint64_t{7} << 32) - 500;
    const ViewerSamples narrow =
        sample_viewers(Device("", 1), test.material, test.light(), {9, first, 1001});
    EXPECT_EQ(narrow.weight.size(), 3U);
    for (const unsigned width : {4U, 16U}) {
        const Device device("", width);
        const ViewerSamples wide =
            sample_viewers(device, test.material, test.light(), {9, first, 1001});
        EXPECT_EQ(narrow.viewer, wide.viewer);
        EXPECT_EQ(narrow.pdf, wide.pdf);
        EXPECT_EQ(narrow.weight, wide.weight);
        const ViewerSamples later =
            sample_viewers(device, test.material, test.light(), {9, first + 77, 3});
        EXPECT_EQ(later.viewer[2], narrow.viewer[79]);
    }
}

/// A pdf beside a sample is that of its direction, however it was drawn.
TEST_F(SamplingOfSums, PdfOfASampleIsItsDensity)
{
    const SamplingCase test = mixture();
    const ViewerSamples samples =
        sample_viewers(*device(), test.material, test.light(), {5, 0, 4000});
    const std::vector<float> density = sampling_density(
        *device(), test.material, test.light(), {samples.viewer.begin(), samples.viewer.end()});
    for (std::size_t k = 0; k < density.size(); ++k)
        EXPECT_NEAR(samples.pdf[k], density[k], 1e-4F * (1 + density[k]));
}

TEST_F(SamplingOfSums, RefuseModelsWithoutASampler)
{
    const Material sum{"sum", {default_lobe("lambert"), default_lobe("oren_nayar")}};
    try {
        sample_viewers(*device(), sum, {}, {});
        FAIL() << "it was sampled";
    } catch (const UsageError& error) {
        EXPECT_THAT(error.what(),
                    testing::AllOf(testing::HasSubstr("`oren_nayar` cannot be sampled"),
                                   testing::HasSubstr("lambert, phong")));
    }
}

}  // namespace
}  // namespace gonio::test
