// SPDX-License-Identifier: Apache-2.0
// A function of the wavelength that was measured at some of them.
#pragma once

#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::skin {

/// Linear between its points.
class Spectrum {
public:
    /// wavelengths: nm, ascending, at least one. `name` is what errors call it.
    Spectrum(std::string name, std::vector<double> wavelengths, std::vector<double> values);

    const std::string& name() const { return name_; }
    const std::vector<double>& wavelengths() const { return wavelengths_; }
    const std::vector<double>& values() const { return values_; }

    /// Throws UsageError that says the range if the wavelength (nm) is not in it.
    double at(double wavelength) const;

private:
    std::string name_;
    std::vector<double> wavelengths_, values_;
};

/// A column of comma-separated numbers: lines with # in front are comments, the first other one
/// names the columns, the first column is the wavelength in nm. An empty `column` is the second.
/// Throws UsageError with file:line:column for what is no number, and where wavelengths do not
/// ascend.
Spectrum read_spectrum(std::istream& stream, const std::string& name, std::string_view column);

/// A column of a file of host/data/, by its path below it.
Spectrum built_in_spectrum(const std::string& path, std::string_view column);

/// A file of host/data/, or nullptr.
const std::string_view* find_data(std::string_view path);

/// The files in a folder of host/data/, by their paths below it.
std::vector<std::string_view> data_paths(std::string_view folder);

}  // namespace gonio::skin
