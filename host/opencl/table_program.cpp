// SPDX-License-Identifier: Apache-2.0
// The specialised program of a material on a grid, and the parameters that it reads.
#include "opencl/table_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "compute/distinct_channels.hpp"
#include "compute/idle_lobes.hpp"
#include "gonio/shared/residual_fields.h"

namespace gonio {
namespace {

bool is_weighted(const Lobe& lobe)
{
    return std::ranges::any_of(lobe.weight, [](double weight) { return weight != 1; });
}

/// What kernels/core/lobe.cl has in place of an option of Fresnel's.
constexpr int facets_reflect_all = -1;

/// What a program leaves out: for which other numbers it holds.
enum class For { all_numbers, all_but_weights, these_numbers };

bool reflects_all(const Lobe& lobe, std::size_t parameter)
{
    return lobe.model->parameters[parameter].name == "fresnel" && even_facet_reflectance(lobe) == 1;
}

/// The program's first lines: core/material.cl says what they define.
std::string preamble(const Material& material, const std::string& directions_file, For numbers)
{
    const bool special = numbers == For::these_numbers, coloured = material.channels() > 1;
    std::string includes = fmt::format("#include \"{}\"\n", directions_file);
    std::string lobes, choices, shared;
    for (std::size_t k = 0; k < material.lobes.size(); ++k) {
        const Lobe& lobe = material.lobes[k];
        includes += fmt::format("#include \"brdf/{}.cl\"\n", lobe.model->id);
        lobes += fmt::format(" LOBE({}, {}, {}, {})", k, lobe.model->id,
                             (lobe.traits() & VALUE) != 0 ? 1 : 0,
                             numbers == For::all_numbers || is_weighted(lobe) ? 1 : 0);
        for (std::size_t p = 0; p < lobe.values.size(); ++p) {
            const Kind kind = lobe.model->parameters[p].kind;
            const auto& values = lobe.values[p];
            if (kind == Kind::choice)
                choices += fmt::format(
                    "{}, ", special && reflects_all(lobe, p) ? facets_reflect_all : values[0]);
            if (kind == Kind::color)
                shared += special && coloured && all_are(values, values.front()) ? "1, " : "0, ";
        }
    }
    return fmt::format("{}#define LOBES{}\n#define CHOICES {}0\n#define SHARED {}0\n", includes,
                       lobes, choices, shared);
}

/// The grid as kernels/core/residual.cl reads it; an empty one for nullptr.
void append(const ResidualGrid* grid, std::vector<float>& values)
{
    std::vector<float> fields(residual_values, 0.0F);
    fields[residual_size] = static_cast<float>(residual_values);
    if (grid != nullptr) {
        fields[residual_size] = static_cast<float>(residual_values + grid->values.size());
        fields[residual_plane] = static_cast<float>(grid->plane());
        fields[residual_channels] = static_cast<float>(grid->channels);
        fields[residual_root] = grid->root ? 1.0F : 0.0F;
        for (std::size_t a = 0; a < grid->positions.size(); ++a) {
            const std::vector<double>& at = grid->positions[a];
            const std::size_t first = a == 2 ? 0 : 1;  // of the samples that are evenly spaced
            fields[residual_count + a] = static_cast<float>(at.size());
            fields[residual_first + a] = static_cast<float>(at[first]);
            fields[residual_inverse_step + a] = static_cast<float>(1 / (at[first + 1] - at[first]));
            if (a == 2) continue;
            const double angle = a == 0 && grid->root ? at.back() * at.back() : at.back();
            fields[residual_last + a] = static_cast<float>(at.back());
            fields[residual_rest + a] = static_cast<float>(std::numbers::pi / 2 - angle);
        }
    }
    values.insert(values.end(), fields.begin(), fields.end());
    if (grid != nullptr) values.insert(values.end(), grid->values.begin(), grid->values.end());
}

}  // namespace

std::vector<std::string> table_definitions(const Material& material, const TableProgram& program)
{
    return {fmt::format("CHANNELS={}", material.channels()),
            fmt::format("MEASURE={}", static_cast<int>(program.measure)),
            fmt::format("ISOTROPIC={}", material.isotropic() ? 1 : 0),
            fmt::format("MIRROR={}", program.mirrored ? 1 : 0),
            fmt::format("RECIPROCAL={}", program.reciprocal ? 1 : 0)};
}

cl::Kernel table_kernel(Device::State& device, const Material& material,
                        const TableProgram& program)
{
    return {build_program(device,
                          preamble(material, program.grid_file,
                                   program.special ? For::these_numbers : For::all_but_weights),
                          "table.cl", table_definitions(material, program), program.width),
            "table"};
}

std::vector<std::string> albedo_definitions(const Material& material, bool isotropic)
{
    return {fmt::format("CHANNELS={}", material.channels()),
            fmt::format("ISOTROPIC={}", isotropic ? 1 : 0)};
}

cl::Kernel albedo_kernel(Device::State& device, const Material& material, bool isotropic)
{
    return {build_program(device, preamble(material, "directions/quadrature.cl", For::all_numbers),
                          "albedo.cl", albedo_definitions(material, isotropic), device.width),
            "albedo"};
}

cl::Kernel sampling_kernel(Device::State& device, const Material& material, const char* name)
{
    return {
        build_program(device, preamble(material, "directions/offset.cl", For::all_numbers),
                      "sample.cl", {fmt::format("CHANNELS={}", material.channels())}, device.width),
        name};
}

std::vector<float> parameter_values(const Material& material)
{
    const std::size_t channels = material.channels();
    std::vector<float> values;
    for (const Lobe& lobe : material.lobes) {
        for (std::size_t p = 0; p < lobe.values.size(); ++p) {
            const Kind kind = lobe.model->parameters[p].kind;
            if (kind == Kind::choice) continue;
            if (kind == Kind::table) {
                append(lobe.table(p).get(), values);
                continue;
            }
            for (std::size_t c = 0; c < (kind == Kind::color ? channels : 1); ++c)
                values.push_back(static_cast<float>(lobe.number(p, c)));
        }
        for (std::size_t c = 0; c < channels; ++c)
            values.push_back(static_cast<float>(lobe.weight[lobe.weight.size() == 1 ? 0 : c]));
    }
    return values;
}

}  // namespace gonio
