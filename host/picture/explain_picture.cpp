// SPDX-License-Identifier: Apache-2.0
// Goes through a picture as make_picture() does.
#include "picture/explain_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "opencl/table_program.hpp"
#include "picture/layer_reflectance.hpp"
#include "picture/lights.hpp"
#include "picture/picture_material.hpp"
#include "picture/surface_albedo.hpp"
#include "picture/work.hpp"

namespace gonio {
namespace {

bool is_uniform(const PictureLight& light)
{
    return std::holds_alternative<UniformLight>(light);
}

class Explanation {
public:
    Explanation(const Device& device, const PictureRequest& picture,
                const std::vector<SceneMaterial>& materials)
        : device_(device),
          picture_(picture),
          materials_(materials),
          lights_(shining(picture.lights)),
          work_(work_of(picture, materials))
    {
        const auto uniform = static_cast<std::size_t>(std::ranges::count_if(lights_, is_uniform));
        directed_ = lights_.size() - uniform;
        is_uniform_ = uniform > 0;
    }

    PicturePlan plan()
    {
        const auto rays = picture_.width * picture_.height * picture_.samples * picture_.samples;
        compute(fmt::format("{} rays, and shadow rays to {} lights from what they meet", rays,
                            directed_),
                static_cast<double>(rays));
        std::set<std::size_t> shown;
        for (const PictureMesh& mesh : picture_.meshes) shown.insert(mesh.material);
        for (const std::size_t which : shown) explain_material(materials_[which]);
        for (std::size_t k = 0; k < materials_.size(); ++k)
            if (!shown.contains(k))
                leave_out(fmt::format("material `{}`", materials_[k].name),
                          "no mesh of the picture is made of it");
        if (const auto dark = picture_.lights.size() - lights_.size(); dark > 0)
            leave_out(fmt::format("{} of {} lights", dark, picture_.lights.size()),
                      "they are black");
        leave_out(fmt::format("{} of {} models", models().size() - models_.size(), models().size()),
                  "no surface is one of them: they are not compiled");
        return plan_;
    }

private:
    void compute(std::string what, double work)
    {
        plan_.stages.push_back({.what = std::move(what), .share = work / work_});
    }

    void run(std::string what, std::string kernel, double work = 0)
    {
        compute(std::move(what), work);
        plan_.stages.back().kernel = std::move(kernel);
    }

    void leave_out(std::string what, std::string why, std::optional<double> saving = std::nullopt)
    {
        plan_.left_out.push_back({std::move(what), std::move(why), saving});
    }

    void explain_material(const SceneMaterial& material)
    {
        const PictureMaterial kept = picture_material(material, !lights_.empty());
        explain_surface(material, kept);
        if (!kept.bands.empty())
            explain_layers(material, kept.bands.size());
        else if (!std::holds_alternative<std::vector<Lobe>>(material.made_of))
            leave_out(fmt::format("layers of `{}`", material.name), "there is no light");
    }

    void explain_surface(const SceneMaterial& material, const PictureMaterial& kept)
    {
        const std::string& name = material.name;
        for (const Lobe& lobe : kept.surface.lobes) models_.insert(lobe.model->id);
        if (const auto* lobes = std::get_if<std::vector<Lobe>>(&material.made_of);
            lobes && lobes->size() > kept.surface.lobes.size())
            leave_out(fmt::format("{} of {} lobes of `{}`",
                                  lobes->size() - kept.surface.lobes.size(), lobes->size(), name),
                      "their weight is 0");
        if (kept.surface.lobes.empty())
            return leave_out(fmt::format("surface of `{}`", name),
                             "its refractive index is that of what lies above");
        if (directed_ > 0) {
            run(fmt::format("`{}`: f cos theta_i of each sample and light", name), "table.cl");
            plan_.stages.back().definitions = table_definitions(
                kept.surface, {"", Measure::brdf_cosine, false, false, device_.width()});
        } else {
            leave_out(fmt::format("BRDF of `{}` at directions", name),
                      "no light comes from one direction");
        }
        if (is_uniform_ || !kept.bands.empty())
            run(fmt::format("`{}`: albedo of the surface at {} cosines", name,
                            SurfaceAlbedo::cosines),
                "albedo.cl");
        else
            leave_out(fmt::format("albedo of `{}`", name), "there is no uniform light");
    }

    void explain_layers(const SceneMaterial& material, std::size_t bands)
    {
        const std::string& name = material.name;
        const auto count = static_cast<double>(bands);
        const auto in_bands = bands == 1 ? "one band" : fmt::format("{} bands", bands);
        compute(fmt::format("`{}`: layers by adding-doubling at {} angles in {} of light", name,
                            LayerReflectance::angles, in_bands),
                count * work_of_band);
        run(fmt::format("`{}`: {} photons in each band", name, picture_.photons),
            "photon/transport.cl", count * work_of_photon * static_cast<double>(picture_.photons));
        run(fmt::format("`{}`: light that spreads from pixel to pixel", name), "picture/spread.cl",
            work_of_spread_pixel * static_cast<double>(picture_.width * picture_.height));
        if (std::holds_alternative<Skin>(material.made_of))
            leave_out(fmt::format("`{}` between every 20 nm", name), "colour does not need it", 4);
        else
            leave_out(fmt::format("colours of `{}`", name),
                      "layers with one set of coefficients are grey");
    }

    const Device& device_;
    const PictureRequest& picture_;
    const std::vector<SceneMaterial>& materials_;
    std::vector<PictureLight> lights_;
    double work_;
    std::size_t directed_ = 0;
    bool is_uniform_ = false;
    std::set<std::string_view> models_;
    PicturePlan plan_;
};

}  // namespace

PicturePlan explain(const Device& device, const PictureRequest& picture,
                    const std::vector<SceneMaterial>& materials)
{
    return Explanation(device, picture, materials).plan();
}

}  // namespace gonio
