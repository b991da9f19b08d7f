// SPDX-License-Identifier: Apache-2.0
// A program outside of the tree: evaluates a model at a point and over a table, through the public
// headers.
#include <cmath>
#include <cstdio>
#include <gonio/compute.hpp>

int main()
{
    gonio::Lobe lobe = gonio::default_lobe("ggx");
    lobe.set("alpha", std::vector{0.3});
    const gonio::Material material{"example", {lobe}};
    const gonio::Device device;

    const float f =
        compute_points(device, material, gonio::Measure::brdf, {{30, 0, 30, 180}})[0][0];
    const auto [l, v] = gonio::unit_vectors({30, 0, 30, 180});
    const double expected = make_reference(material, gonio::Measure::brdf)(l, v, 0);
    const gonio::Grid grid = gonio::isotropic_grid(8, 8, 16, gonio::Samples::centre);
    const gonio::Table table = compute_table(device, material, gonio::Measure::brdf, grid);
    std::printf("f_r = %g/sr, a table of %zu values\n", static_cast<double>(f),
                table.values[0].size());
    return std::abs(f / expected - 1) < 1e-5 && table.values[0].size() == 8 * 8 * 16 ? 0 : 1;
}
