// SPDX-License-Identifier: Apache-2.0
// What is measured of a model on a device.
#include "verify/measure.hpp"

#include <algorithm>
#include <array>

#include "gonio/compute.hpp"
#include "opencl/store_rate.hpp"

namespace gonio {
namespace {

/// Without symmetry, so that every cell is an evaluation. The middle one of three runs.
double values_per_second(const Device& device, const Model& model)
{
    const Material material{std::string(model.id), {default_lobe(model.id)}};
    constexpr std::size_t thetas = 64, azimuths = 1024;
    const Grid grid = isotropic_grid(thetas, thetas, azimuths, Samples::centre, 180);
    std::array<double, 3> seconds{};
    for (double& run : seconds)
        run = compute_grid(device, material, Measure::brdf, grid, [](const Rows<float>&) {},
                           {.leave_out = false})
                  .kernel_seconds;
    std::ranges::sort(seconds);
    return static_cast<double>(thetas * thetas * azimuths) / seconds[1];
}

}  // namespace

Measured measure_model(const Device& device, const Model& model)
{
    Measured measured{verify_model(device, model, false), values_per_second(device, model), 0,
                      largest_albedo(device, model)};
    measured.store_fraction = measured.values_per_second / stored_values_per_second(device);
    return measured;
}

}  // namespace gonio
