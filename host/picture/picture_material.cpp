// SPDX-License-Identifier: Apache-2.0
// Lobes are surfaces, and layers have one.
#include "picture/picture_material.hpp"

#include <fmt/format.h>

#include <set>

#include "compute/idle_lobes.hpp"
#include "gonio/errors.hpp"
#include "picture/lights.hpp"
#include "picture/work.hpp"

namespace gonio {
namespace {

constexpr double facet_alpha = 0.35;
constexpr double facet_wavelength = 580;  // nm

std::vector<Lobe> facets_of(const LayeredMedium& medium)
{
    const double eta = medium.layers.front().n / medium.n_above;
    if (eta == 1) return {};
    Lobe lobe = default_lobe("ggx");
    lobe.set("fresnel", "dielectric");
    lobe.set("eta", {eta});
    lobe.set("alpha", {facet_alpha});
    return {lobe};
}

}  // namespace

PictureMaterial picture_material(const SceneMaterial& material, bool lit)
{
    if (!material.sweeps.empty())
        throw UsageError(fmt::format("{}material `{}` has sweeps; a picture shows one value",
                                     material.where, material.name));
    if (const auto* lobes = std::get_if<std::vector<Lobe>>(&material.made_of))
        return {without_idle_lobes({material.name, *lobes, material.ambient}), {}};
    PictureMaterial found{{material.name, {}}, {}};
    if (material.surface) found.surface.lobes = {*material.surface};
    if (const auto* skin = std::get_if<Skin>(&material.made_of)) {
        if (!material.surface) found.surface.lobes = facets_of(skin->layers_at(facet_wavelength));
        if (lit) found.bands = bands_of(*skin);
    } else {
        const auto& medium = std::get<LayeredMedium>(material.made_of);
        if (!material.surface) found.surface.lobes = facets_of(medium);
        if (lit) found.bands = {{medium}};
    }
    return found;
}

double work_of(const PictureRequest& picture, const std::vector<SceneMaterial>& materials)
{
    const auto pixels = static_cast<double>(picture.width * picture.height);
    double work = pixels * static_cast<double>(picture.samples * picture.samples);
    std::set<std::size_t> shown;
    for (const PictureMesh& mesh : picture.meshes) shown.insert(mesh.material);
    for (const std::size_t which : shown) {
        const auto bands = static_cast<double>(
            picture_material(materials[which], !shining(picture.lights).empty()).bands.size());
        if (bands == 0) continue;
        work += bands * (work_of_band + work_of_photon * static_cast<double>(picture.photons)) +
                work_of_spread_pixel * pixels;
    }
    return work;
}

}  // namespace gonio
