// SPDX-License-Identifier: Apache-2.0
// The scenes of faces at their own size, programs built anew, and what pictures of skin
// approximate.
//   seconds     of a picture, without reading the scene and writing the file
//   megapixels  of it
//   edge        error behind the edge of a half-plane of light; the photons have other numbers than
//               those that Gaussians were fitted to, and are four times as many
//   shape       relative error of the separable BRDF of layers at 600 nm
#include <benchmark/benchmark.h>

#include <chrono>
#include <string>

#include "gonio/scene.hpp"
#include "verify/picture_errors.hpp"

namespace gonio {
namespace {

void face(benchmark::State& state, const std::string& name)
{
    const Scene scene = load_scene(SCENES "/" + name + ".toml");
    const PictureRequest& picture = scene.picture.value();
    for (auto _ : state) {
        const auto start = std::chrono::steady_clock::now();
        const Device device;
        benchmark::DoNotOptimize(make_picture(device, picture, scene.materials));
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
        state.counters["seconds"] = took.count();
        state.SetLabel(device.info().name + ", vector width " + std::to_string(device.width()));
    }
    state.counters["megapixels"] = 1e-6 * static_cast<double>(picture.width * picture.height);
}

void skin(benchmark::State& state, const std::string& model)
{
    const Device device;
    const Skin skin(find_skin_model(model));
    const auto bands = bands_of(skin);
    const ProfileRequest fitted, other{.photons = 4 * fitted.photons, .seed = fitted.seed + 1};
    for (auto _ : state) {
        const auto gaussians = fit_gaussians(trace_profile(device, bands, fitted)).function;
        state.counters["edge"] =
            error_behind_an_edge(device, gaussians, trace_profile(device, bands, other));
        state.counters["shape"] = error_of_separable_shape(skin.layers_at(600));
    }
}

const bool registered = [] {
    for (const std::string name : {"face_phong", "face_lambert", "face_skin"})
        benchmark::RegisterBenchmark(("pictures/" + name).c_str(),
                                     [name](benchmark::State& state) { face(state, name); })
            ->Iterations(1)
            ->Unit(benchmark::kMillisecond);
    for (const std::string model : {"jacques_1998", "meglinski_2002"})
        benchmark::RegisterBenchmark(("pictures/skin/" + model).c_str(),
                                     [model](benchmark::State& state) { skin(state, model); })
            ->Iterations(1)
            ->Unit(benchmark::kMillisecond);
    return true;
}();

}  // namespace
}  // namespace gonio
