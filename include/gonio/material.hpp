// SPDX-License-Identifier: Apache-2.0
// Materials: weighted sums of reflectance models with their parameters.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "gonio/model.hpp"
#include "gonio/residual.hpp"

namespace gonio {

inline constexpr std::size_t max_channels = 4;

/// One model with its parameters. values[k] belongs to model->parameters[k]: one number, for a
/// color one number or one per channel, for a choice the number of the option, for a table 0.
/// Numbers are in the registry's units (angles in degrees).
struct Lobe {
    const Model* model = nullptr;
    std::vector<std::vector<double>> values;
    std::vector<double> weight = {1.0};
    /// Of parameter k if that is a table; empty, or nullptr, where no file was read.
    std::vector<std::shared_ptr<const ResidualGrid>> tables = {};

    /// Sets a parameter, both parameters of a common name, or a choice ("weight" sets the weight);
    /// a table from the file of that name, and the parameters that the file gives. Throws
    /// UsageError that names the allowed range and the nearest name, and as read_residual().
    void set(std::string_view name, const std::vector<double>& numbers);
    void set(std::string_view name, std::string_view option);

    unsigned traits() const;  ///< of the model and its chosen options
    bool isotropic() const;
    std::size_t channels() const;
    /// The grid of a parameter, or nullptr.
    std::shared_ptr<const ResidualGrid> table(std::size_t parameter) const;
    /// The number that a parameter has in a channel, angles in radians.
    double number(std::size_t parameter, std::size_t channel) const;
};

/// The model or alias of that name with default parameters. Throws UsageError with the nearest
/// name.
Lobe default_lobe(std::string_view name);

struct Material {
    std::string name;
    std::vector<Lobe> lobes;
    /// A constant radiance for each channel, or one for all, which pictures add under a light of
    /// unit irradiance: the ambient term of Phong's shading. It is no part of the BRDF.
    std::vector<double> ambient = {};

    bool isotropic() const;
    std::size_t channels() const;
    /// "Y" for one channel, "R", "G", "B", "A" for more.
    std::vector<std::string> channel_names() const;
};

/// What a kernel or reference is asked for: what the model prints (eval), f_r, or f_r cos theta_i.
enum class Measure { as_printed, brdf, brdf_cosine };

/// Which parameters a reference works with: those that kernels see, rounded to float, or those
/// given, to be compared with numbers in the literature.
enum class Parameters { rounded, as_given };

/// f(l, v, channel) in double from the scalar reference: l, v unit vectors to light and viewer in
/// the frame where n is +z, l.z, v.z > 0.
using Reference = std::function<double(glm::dvec3 l, glm::dvec3 v, std::size_t channel)>;

Reference make_reference(const Material& material, Measure measure,
                         Parameters parameters = Parameters::rounded);

/// The part of the light from l that the mirror terms of the material's wave models reflect, in a
/// channel; 0 if it has none.
double specular_reflectance(const Material& material, glm::dvec3 l, std::size_t channel);

}  // namespace gonio
