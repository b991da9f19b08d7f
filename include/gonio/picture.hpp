// SPDX-License-Identifier: Apache-2.0
// Pictures of meshes: a camera, lights, and materials whose BRDFs a device evaluates.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "gonio/device.hpp"
#include "gonio/table.hpp"

namespace gonio {

struct SceneMaterial;

/// A pinhole. Lengths are in the unit of the meshes.
struct Camera {
    glm::dvec3 from{0, 0, 1}, to{0, 0, 0}, up{0, 1, 0};
    double field_of_view = 40;  ///< from the upper to the lower edge, degrees
};

/// An OBJ file (Wavefront) and where it stands: scale times its coordinates, plus `translate`.
struct PictureMesh {
    std::filesystem::path file;
    std::size_t material = 0;  ///< index into Scene::materials
    double scale = 1;
    glm::dvec3 translate{0};
    std::string where;  ///< what messages begin with
};

/// Light from far away. Colours are linear sRGB.
struct DirectionalLight {
    glm::dvec3 towards;     ///< unit vector from the surface to the light
    glm::dvec3 irradiance;  ///< at normal incidence
};

/// Light from a point; its irradiance falls as 1 / distance^2.
struct PointLight {
    glm::dvec3 position;
    glm::dvec3 intensity;  ///< irradiance at normal incidence and distance 1
};

/// The same radiance from everywhere. No mesh hides it, so that it is exact for convex ones.
struct UniformLight {
    glm::dvec3 radiance;
};

using PictureLight = std::variant<DirectionalLight, PointLight, UniformLight>;

struct PictureRequest {
    std::string title;  ///< its caption beside others
    std::size_t width = 512, height = 512;
    std::size_t samples = 2;  ///< along each side of a pixel
    glm::dvec3 background{0};
    double metres_per_unit = 1;       ///< of all lengths: light spreads in skin by millimetres
    std::uint64_t photons = 100'000;  ///< in each band of light, for how far it spreads
    std::optional<double> exposure;   ///< of .png; set by the picture's bright parts if not given
    Camera camera;
    std::vector<PictureMesh> meshes;
    std::vector<PictureLight> lights;
    std::string where;
};

/// Called when something begins, with 0, and after each part of it, with how much that was; never
/// by two threads at once.
using PictureProgress = std::function<void(std::string_view doing, double amount)>;

/// Radiance, linear sRGB: axes y from the top and x, channels R, G, B. What a light at l adds is
/// f(l, v) cos theta_i times its irradiance, where no mesh stands between; a material's `ambient`
/// is added everywhere. Both sides of a surface reflect. The tangent +x of brushed materials runs
/// along circles of latitude around the camera's `up`. Normals are those of the file, else averages
/// over the triangles at a vertex weighted by area; near where such a normal turns from the light,
/// shadow rays start above the flat triangle, on the surface that the normals tell of (Hanika, Ray
/// Tracing Gems II, 2021, ch. 4), and a normal that turns from the viewer is bent back. The same
/// bytes at every vector width and number of threads.
///
/// Skin, and other layers, reflect by their surface, and what enters the layers leaves them as
/// rho(mu_i) rho(mu_o)/(pi mean) tells (picture/layer_reflectance.hpp), spread over the surface
/// that the picture shows by six Gaussians fitted to photons of a beam along the normal. Layers
/// given by their coefficients are grey. What the picture does not need is neither compiled nor
/// computed: materials that no ray meets, black lights, lobes of weight 0. Throws UsageError for a
/// mesh that cannot be read, with file and line, and for a material with sweeps, and what
/// `after_each` throws, which ends the work.
Table make_picture(
    const Device& device, const PictureRequest& picture,
    const std::vector<SceneMaterial>& materials,
    const PictureProgress& after_each = [](std::string_view, double) {});

/// A picture with what is said below it.
struct PictureCard {
    Table picture;
    std::optional<double> exposure;
    std::string caption;
};

/// Writes pictures side by side as PNG. Throws RunError.
void write_picture_sheet(const std::filesystem::path& path, const std::vector<PictureCard>& cards);

/// Throws UsageError unless the name ends in .exr or .png.
void check_picture_name(const std::filesystem::path& path);

/// Writes a picture, .exr (linear) or .png (sRGB, multiplied by `exposure`, or exposed for its
/// bright parts). Throws as check_picture_name(), and RunError where the disk refuses.
void write_picture(const std::filesystem::path& path, const Table& picture,
                   const std::optional<double>& exposure);

}  // namespace gonio
