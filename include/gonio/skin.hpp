// SPDX-License-Identifier: Apache-2.0
// Models of skin: from melanin and blood to layers at a wavelength, and from those to a spectrum.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "gonio/layers.hpp"

namespace gonio {

namespace skin {
struct Recipe;
}

struct SkinParameter {
    std::string name;
    std::string unit;  ///< "1", "cm" or "g/L"
    double least = 0, greatest = 0, preset = 0;
    std::string doc = {};
};

/// Layers as recipes of substances and laws, with parameters.
struct SkinModel {
    std::string id, title, citation;
    std::vector<SkinParameter> parameters = {};  ///< in the order of the file
    std::vector<std::string> layers = {};        ///< names, from the top
    std::vector<std::string> notes = {};         ///< what a user should know: limits, our readings
    std::vector<std::string> held = {};          ///< parameters that fits keep if nobody asks
    std::shared_ptr<const skin::Recipe> recipe = {};

    /// Throws UsageError with the nearest name.
    std::size_t index_of(std::string_view parameter) const;
};

/// The models that are built in.
std::vector<std::string> skin_model_names();

/// A model that is built in, by its name, or any other by its file, which ends in ".toml". Throws
/// UsageError with the nearest name, or with file:line:column, key, range and nearest name.
SkinModel find_skin_model(const std::string& name_or_file);

/// A model with numbers for its parameters; the defaults at first.
class Skin {
public:
    explicit Skin(SkinModel model);

    const SkinModel& model() const { return model_; }
    const std::vector<double>& values() const { return values_; }

    /// Throws UsageError with the nearest name or the range.
    void set(std::string_view parameter, double value);

    /// Wavelengths in nm, at which the model and all its spectra hold; both are included.
    double least_wavelength() const;
    double greatest_wavelength() const;

    /// wavelength: nm. Throws UsageError where it is out of range, where fractions are not in
    /// [0, 1] or sum past 1, and as validate() does.
    LayeredMedium layers_at(double wavelength) const;

private:
    SkinModel model_;
    std::vector<double> values_;
};

/// A parameter that takes several values, which ascend or descend.
struct SkinLadder {
    std::string parameter;
    std::vector<double> values;
};

/// What spectra are asked for, and how exact.
struct SkinTask {
    Skin skin;
    std::vector<SkinLadder> ladders = {};  ///< from the outermost
    std::vector<double> wavelengths = {};  ///< nm
    LightSource light = {};
    double tolerance = 1e-4;
};

/// Where light of unit flux ends, at each wavelength.
struct SkinSpectrum {
    std::vector<double> wavelengths;  ///< nm
    /// All that returns, with what the surface reflects: what a spectrophotometer with a sphere
    /// measures when its gloss trap is closed.
    std::vector<double> reflectance;
    std::vector<double> specular;       ///< of that, what the surface reflects (MCML's Rsp)
    std::vector<double> transmittance;  ///< leaves below
    std::vector<double> bottom;         ///< absorbed below the layers
    std::vector<std::vector<double>> absorption;  ///< [layer][wavelength]
    double error = 0;                             ///< bound of all of these
};

/// 380 to 780 nm in steps of 5.
std::vector<double> default_wavelengths();

/// The spectra of several sets of one model by adding-doubling, without noise, on all processors.
/// `tolerance` is that of each number; the error is measured at every sixteenth wavelength. Throws
/// as layers_at() does, and RunError where it cannot be reached.
/// `after_each` is called after each wavelength, by several threads; what it throws ends the work.
std::vector<SkinSpectrum> solve_skin(
    const std::vector<Skin>& sets, const std::vector<double>& wavelengths, const LightSource& light,
    double tolerance, const std::function<void()>& after_each = [] {});

}  // namespace gonio
