// SPDX-License-Identifier: Apache-2.0
// Layers in pictures: what they return by angle, and their energy.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compute/shared_device.hpp"
#include "gonio/albedo.hpp"
#include "gonio/colour.hpp"
#include "gonio/errors.hpp"
#include "picture/layer_reflectance.hpp"
#include "picture/mesh_fixtures.hpp"
#include "picture/picture_material.hpp"
#include "verify/picture_errors.hpp"

namespace gonio {
namespace {

using glm::dvec3;

class SkinInPictures : public test::SharedDevice {
protected:
    static Skin skin() { return Skin(find_skin_model("jacques_1998")); }
    static Material surface()
    {
        return picture_material({.name = "skin", .made_of = skin(), .sweeps = {}, .where = {}},
                                false)
            .surface;
    }

    static double surface_albedo(double cosine)
    {
        return integrate_albedos(*device(), {surface()}, {{0, {cosine, 0}}}).value[0][0];
    }
};

TEST_F(SkinInPictures, LayersReturnWhatSpectraSayOfTheLightThatTheSurfaceLeaves)
{
    const LayerReflectance reflectance(*device(), bands_of(skin()), surface());
    std::vector<double> wavelengths;
    for (int at = 380; at <= 780; at += 10) wavelengths.push_back(at);
    for (const double theta : {0.7, 1.3}) {
        const LightSource light{.beam = Beam::pencil, .incidence = theta};
        const SkinSpectrum spectrum = solve_skin({skin()}, wavelengths, light, 1e-3).front();
        std::vector<double> layers;
        for (std::size_t k = 0; k < spectrum.wavelengths.size(); ++k)
            layers.push_back((spectrum.reflectance[k] - spectrum.specular[k]) /
                             (1 - spectrum.specular[k]));
        const double cosine = std::cos(theta);
        const dvec3 expected =
            (1 - surface_albedo(cosine)) * linear_srgb(tristimulus(spectrum.wavelengths, layers));
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(reflectance.at(cosine)[c], expected[c], 4e-3) << theta;
    }
}

// The layers' own BRDF at 600 nm, solved, against the shape that pictures take for it.
TEST_F(SkinInPictures, TheSeparableShapeIsNearTheLayersOwn)
{
    EXPECT_LT(error_of_separable_shape(skin().layers_at(600)), 0.08);
}

// All light that comes back from the surface and from the layers, whatever spreads in between.
TEST_F(SkinInPictures, UniformLightComesBackByTheAlbedosOfSurfaceAndLayers)
{
    const test::MeshFolder folder;
    folder.add("plane.obj", "v -9 -9 0\nv 9 -9 0\nv 9 9 0\nv -9 9 0\nf 1 2 3 4\n");
    const Table table = folder.picture(*device(), R"(
[[material]]
name = "skin"
skin = "jacques_1998"
[picture]
width = 9
height = 7
samples = 1
photons = 1000
camera = { from = [0, -3, 4], to = [0, 0, 0], field_of_view = 4 }
mesh = [{ file = "plane.obj", material = "skin" }]
light = [{ kind = "uniform", radiance = 2 }]
)");
    const LayerReflectance reflectance(*device(), bands_of(skin()), surface());
    const dvec3 expected = 2.0 * (dvec3(surface_albedo(0.8)) + reflectance.at(0.8));
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(test::pixel_of(table, 4, 3)[c], expected[c], 2e-3 * expected[c]);
}

/// A ball of layers in uniform light of radiance 1, seen before as much.
PictureRequest furnace(const test::MeshFolder& folder)
{
    folder.add("ball.obj", test::sphere_obj(12, 24));
    PictureRequest request;
    request.width = request.height = 16;
    request.samples = 1;
    request.background = dvec3(1);
    request.photons = 100;
    request.metres_per_unit = 1e-3;
    request.camera = {.from = {0, 0, 4}, .to = {0, 0, 0}, .field_of_view = 40};
    request.meshes = {{.file = folder.path() / "ball.obj", .where = {}}};
    request.lights = {UniformLight{dvec3(1)}};
    return request;
}

std::vector<SceneMaterial> layers(const Layer& layer, Bottom bottom)
{
    return {{.name = "white",
             .made_of = LayeredMedium{.layers = {layer}, .bottom = bottom, .bottom_albedo = 1},
             .sweeps = {},
             .where = {}}};
}

// Nothing is lost: what the surface reflects does not enter, and all that enters leaves. How it is
// distributed over angles and places is approximated, and uniform light does not show that.
TEST_F(SkinInPictures, AWhiteFurnaceOfLosslessLayersHasNoContrast)
{
    const test::MeshFolder folder;
    const PictureRequest request = furnace(folder);
    const Layer matched{.mus = 100, .n = 1, .phase = HenyeyGreenstein{0.8}},
        mismatched{.mus = 100, .n = 1.4, .phase = HenyeyGreenstein{0.8}},
        over_white{.mus = 5, .n = 1.4, .d = 0.1, .phase = Isotropic{}};
    for (const auto& materials : {layers(matched, Bottom::open), layers(mismatched, Bottom::open),
                                  layers(over_white, Bottom::diffuse)}) {
        const Table table = make_picture(*device(), request, materials);
        for (const auto& plane : table.values)
            for (const double value : plane) EXPECT_NEAR(value, 1, 5e-6);
    }
}

TEST_F(SkinInPictures, ProgressTellsAllOfTheWorkAndMayEndIt)
{
    const test::MeshFolder folder;
    const PictureRequest request = furnace(folder);
    const auto materials = layers({.mua = 1, .mus = 100, .n = 1.4}, Bottom::open);
    std::vector<std::string> steps;
    double done = 0;
    make_picture(*device(), request, materials, [&](std::string_view doing, double amount) {
        if (steps.empty() || steps.back() != doing) steps.emplace_back(doing);
        done += amount;
    });
    EXPECT_EQ(steps,
              (std::vector<std::string>{"layers by angle", "photons", "rays", "spread of light"}));
    EXPECT_NEAR(done, work_of(request, materials), 1e-9 * done);
    for (const std::string& last : steps)
        EXPECT_THROW(make_picture(*device(), request, materials,
                                  [&](std::string_view doing, double amount) {
                                      if (doing == last && amount > 0) throw Interrupted();
                                  }),
                     Interrupted)
            << last;
}

}  // namespace
}  // namespace gonio
