// SPDX-License-Identifier: Apache-2.0
// Pictures against closed forms: every model on a sphere, light's distance, shadows, white
// furnaces.
#include "gonio/picture.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "compute/shared_device.hpp"
#include "gonio/errors.hpp"
#include "gonio/material.hpp"
#include "picture/mesh_fixtures.hpp"
#include "picture/surface.hpp"

namespace gonio {
namespace {

using glm::dvec3;
using test::pixel_of;

class Pictures : public test::SharedDevice {
protected:
    /// Materials, then what a picture has besides a camera at z = 4 that sees a unit sphere.
    Table picture(const std::string& materials, const std::string& rest,
                  const std::string& size = "width = 9\nheight = 9\nsamples = 1") const
    {
        return folder_.picture(
            *device(), fmt::format("{}\n[picture]\n{}\ncamera = {{ from = [0, 0, 4], to = [0, 0, "
                                   "0], field_of_view = 16 }}\n{}\n",
                                   materials, size, rest));
    }

    static std::string lambert(double rho)
    {
        return fmt::format(
            "[[material]]\nname = \"white\"\nmodel = \"lambert\"\nparameters = {{ "
            "rho = {} }}\n",
            rho);
    }

    static std::string mesh(const std::string& file)
    {
        return fmt::format("[[picture.mesh]]\nfile = \"{}\"\nmaterial = \"white\"\n", file);
    }

    static std::string light(const std::string& lines)
    {
        return "[[picture.light]]\n" + lines + "\n";
    }

    test::MeshFolder folder_;
};

const std::string uniform = "kind = \"uniform\"\nradiance = 0.7";

/// Where the ray through the middle of a pixel of such a picture meets the unit sphere.
struct SpherePoint {
    dvec3 direction, normal;

    SpherePoint(std::size_t x, std::size_t y, std::size_t size)
    {
        const double half = static_cast<double>(size) / 2;
        const double step = std::tan(8 * M_PI / 180) / half;
        direction = glm::normalize(dvec3(step * (static_cast<double>(x) + 0.5 - half),
                                         step * (half - static_cast<double>(y) - 0.5), -1));
        const double b = 4 * direction.z;
        normal = dvec3(0, 0, 4) + (-b - std::sqrt(b * b - 15)) * direction;
    }

    /// In the frame whose x runs along circles of latitude around y.
    dvec3 local(dvec3 vector) const
    {
        const dvec3 east = glm::normalize(glm::cross(dvec3(0, 1, 0), normal));
        return {glm::dot(vector, east), glm::dot(vector, glm::cross(normal, east)),
                glm::dot(vector, normal)};
    }
};

// The cap's quads are 0.4 degrees wide, so that its normals are the sphere's to 1e-5.
TEST_F(Pictures, OfASphereShowEveryModelAsItsReference)
{
    const dvec3 towards = glm::normalize(dvec3(0.3, 0.5, 1));
    const std::array irradiance{2.0, 1.0, 0.5};
    PictureRequest request;
    request.width = request.height = 9;
    request.samples = 1;
    request.camera = {.from = {0, 0, 4}, .to = {0, 0, 0}, .field_of_view = 16};
    request.lights.push_back(DirectionalLight{towards, {2, 1, 0.5}});
    const Geometry geometry({parse_mesh(test::sphere_obj(96, 600, 36), "cap.obj")});
    const std::vector<Sample> samples = Rays(request).meet(geometry, 0, 9);
    ASSERT_EQ(samples.size(), 81u);
    // Three models a program, each in a channel of its own, since building takes all the time.
    for (std::size_t first = 0; first < models().size(); first += 3) {
        Material material{"three", {}};
        for (std::size_t m = first; m < std::min(first + 3, models().size()); ++m) {
            std::vector<double> weight(3);
            weight[m - first] = 1;
            material.lobes.push_back(default_lobe(models()[m].id));
            material.lobes.back().set("weight", weight);
        }
        const Reference reference = make_reference(material, Measure::brdf_cosine);
        const auto radiance = Surface(*device(), request, material).radiance(geometry, samples);
        for (std::size_t c = 0; c < material.lobes.size(); ++c) {
            std::vector<double> expected;
            for (std::size_t k = 0; k < samples.size(); ++k) {
                const SpherePoint at(k % 9, k / 9, 9);
                expected.push_back(irradiance[c] *
                                   reference(at.local(towards), at.local(-at.direction), c));
            }
            const double greatest = *std::ranges::max_element(expected);
            EXPECT_GT(greatest, 0);
            for (std::size_t k = 0; k < samples.size(); ++k)
                EXPECT_NEAR(radiance[k][static_cast<int>(c)], expected[k],
                            1e-4 * expected[k] + 1e-6 * greatest)
                    << models()[first + c].id << " at " << k;
        }
    }
}

TEST_F(Pictures, APointLightFallsWithTheSquareOfItsDistance)
{
    folder_.add("cap.obj", test::sphere_obj(64, 256, 30));
    const Table table =
        picture(lambert(0.5),
                mesh("cap.obj") + light("kind = \"point\"\nposition = [0, 0, 3]\nintensity = 8"));
    const SpherePoint at(6, 4, 9);
    const dvec3 way = dvec3(0, 0, 3) - at.normal;
    const double cosine = glm::dot(glm::normalize(way), at.normal);
    EXPECT_NEAR(pixel_of(table, 4, 4).y, 8 / 4.0 * 0.5 / M_PI, 1e-5);
    EXPECT_NEAR(pixel_of(table, 6, 4).y, 8 * cosine / glm::dot(way, way) * 0.5 / M_PI, 2e-5);
}

TEST_F(Pictures, AMeshHidesLightFromAnother)
{
    folder_.add("ball.obj", test::sphere_obj(32, 64));
    const std::string small =
        mesh("ball.obj") + "scale = 0.1\ntranslate = [0, 0, 1.5]\n" + mesh("ball.obj");
    const std::string sun = light("kind = \"directional\"\ntowards = [0, 0.3, 1]\nirradiance = 1");
    const Table alone = picture(lambert(0.5), mesh("ball.obj") + sun),
                shaded = picture(lambert(0.5), small + sun);
    int darker = 0;
    for (std::size_t k = 0; k < alone.values[0].size(); ++k)
        darker += shaded.values[0][k] == 0 && alone.values[0][k] > 0;
    EXPECT_GT(darker, 0);
    EXPECT_LT(darker, 5);
}

// A coarse ball without normals: no pixel that the normals turn to the light may be black.
TEST_F(Pictures, NoTriangleShadesItselfWhereItsNormalsFaceTheLight)
{
    folder_.add("coarse.obj", test::sphere_obj(8, 12, 180, false));
    const Table table =
        picture(lambert(1),
                mesh("coarse.obj") +
                    light("kind = \"directional\"\ntowards = [1, 0.2, 0.1]\nirradiance = 1"),
                "width = 60\nheight = 60\nsamples = 1");
    for (std::size_t y = 10; y < 50; ++y) {
        double last = 0;
        for (std::size_t x = 14; x < 46; ++x) {
            const double shown = pixel_of(table, x, y).x;
            EXPECT_TRUE(shown > 0 || last < 0.05) << x << ", " << y;
            last = shown;
        }
    }
}

TEST_F(Pictures, AWhiteFurnaceHasNoContrast)
{
    folder_.add("ball.obj", test::sphere_obj(16, 32));
    const Table table = picture(lambert(1), mesh("ball.obj") + light(uniform),
                                "width = 32\nheight = 32\nbackground = 0.7");
    for (const auto& plane : table.values)
        for (const double value : plane) EXPECT_NEAR(value, 0.7, 2e-6);
}

TEST_F(Pictures, ABrushedMaterialReflectsUniformLightByItsAlbedo)
{
    folder_.add("cap.obj", test::sphere_obj(64, 256, 60));
    const std::string ward =
        "[[material]]\nname = \"white\"\nmodel = \"ward\"\nparameters = { "
        "alpha_x = 0.1, alpha_y = 0.5, rho_s = 1 }\n";
    const Table table = picture(ward, mesh("cap.obj") + light(uniform));
    Lobe lobe = default_lobe("ward");
    lobe.set("alpha_x", {0.1});
    lobe.set("alpha_y", {0.5});
    lobe.set("rho_s", {1});
    const Reference reference = make_reference(Material{"ward", {lobe}}, Measure::brdf_cosine);
    const SpherePoint at(7, 6, 9);
    const dvec3 viewer = at.local(-at.direction);
    double sum = 0;  // midpoints, half a degree apart
    const double step = M_PI / 360;
    for (double theta = step / 2; theta < M_PI / 2; theta += step)
        for (double phi = step / 2; phi < 2 * M_PI; phi += step)
            sum += std::sin(theta) * step * step *
                   reference({std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                              std::cos(theta)},
                             viewer, 0);
    EXPECT_NEAR(pixel_of(table, 7, 6).x, 0.7 * sum, 1e-3);
}

TEST_F(Pictures, ACameraInsideSeesTheOtherSide)
{
    folder_.add("ball.obj", test::sphere_obj(32, 64));
    const std::string large = mesh("ball.obj") + "scale = 10\n";
    const Table lit = picture(lambert(0.5), large + light("kind = \"point\"\nposition = [0, 0, "
                                                          "0]\nintensity = 100"));
    EXPECT_NEAR(pixel_of(lit, 4, 4).x, 0.5 / M_PI, 1e-3);
    const Table dark = picture(
        lambert(0.5), large + light("kind = \"directional\"\ntowards = [0, 0, 1]\nirradiance = 1"));
    for (const double value : dark.values[0]) EXPECT_EQ(value, 0);
}

TEST_F(Pictures, BitsDoNotDependOnTheVectorWidth)
{
    folder_.add("ball.obj", test::sphere_obj(12, 24));
    const std::string material =
        "[[material]]\nname = \"white\"\nambient = 0.1\ndiffuse = { model = "
        "\"lambert\" }\nspecular = { model = \"phong\", weight = 0.2 }\n";
    const std::string rest =
        mesh("ball.obj") +
        light("kind = \"directional\"\ntowards = [0.5, 0.5, 1]\nirradiance = [1, 2, 3]");
    const Table wide = picture(material, rest);
    device() = std::make_unique<Device>("", 1);
    const Table narrow = picture(material, rest);
    device() = std::make_unique<Device>("", 8);
    EXPECT_EQ(wide.values, narrow.values);
}

TEST_F(Pictures, OfBadMeshesAreRefusedWithTheScenesPlace)
{
    folder_.add("empty.obj", "# nothing\n");
    const auto refusal = [&](const std::string& name) -> std::string {
        try {
            picture(lambert(1), mesh(name));
        } catch (const UsageError& error) {
            return error.what();
        }
        return {};
    };
    EXPECT_THAT(refusal("empty.obj"),
                testing::MatchesRegex(".*scene.toml:[0-9]+:8: "
                                      ".*empty.obj: there is no face with an area in it"));
    EXPECT_THAT(refusal("none.obj"), testing::HasSubstr("none.obj: cannot be read: No such file"));
}

}  // namespace
}  // namespace gonio
