// SPDX-License-Identifier: Apache-2.0
// Reads spectra and interpolates between their points.
#include "skin/spectrum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "gonio/errors.hpp"
#include "gonio/model.hpp"
#include "opencl/embedded.hpp"
#include "output/csv_lines.hpp"

namespace gonio::skin {
namespace {

constexpr std::string_view root = "data/";

std::size_t find_column(const CsvLines& lines, std::string_view column)
{
    const std::vector<std::string_view> names = lines.fields();
    if (names.size() < 2) lines.fail("a spectrum needs a column of wavelengths and another one");
    if (column.empty()) return 1;
    const auto found = std::ranges::find(names, column);
    if (found == names.end())
        lines.fail(fmt::format("there is no column `{}`{}", column, suggestion(column, names)));
    return static_cast<std::size_t>(found - names.begin());
}

double finite_number(const CsvLines& lines, std::string_view field)
{
    if (field.empty()) lines.fail(field, "a number is missing");
    const auto number = lines.number<double>(field);
    if (!std::isfinite(number)) lines.fail(field, fmt::format("{} is not finite", field));
    return number;
}

}  // namespace

Spectrum::Spectrum(std::string name, std::vector<double> wavelengths, std::vector<double> values)
    : name_(std::move(name)), wavelengths_(std::move(wavelengths)), values_(std::move(values))
{
}

double Spectrum::at(double wavelength) const
{
    if (!(wavelength >= wavelengths_.front() && wavelength <= wavelengths_.back()))
        throw UsageError(fmt::format("{} nm is outside of `{}`; it holds {} to {} nm", wavelength,
                                     name_, wavelengths_.front(), wavelengths_.back()));
    const auto above = std::ranges::upper_bound(wavelengths_, wavelength);
    if (above == wavelengths_.end()) return values_.back();
    const auto k = static_cast<std::size_t>(above - wavelengths_.begin());
    const double share =
        (wavelength - wavelengths_[k - 1]) / (wavelengths_[k] - wavelengths_[k - 1]);
    return std::lerp(values_[k - 1], values_[k], share);
}

Spectrum read_spectrum(std::istream& stream, const std::string& name, std::string_view column)
{
    CsvLines lines(stream, name);
    std::vector<double> wavelengths, values;
    std::size_t chosen = 0;
    while (lines.next()) {
        if (lines.line().empty() || lines.line().starts_with('#')) continue;
        if (chosen == 0) {
            chosen = find_column(lines, column);
            continue;
        }
        const std::vector<std::string_view> fields = lines.fields();
        if (fields.size() <= chosen)
            lines.fail(fmt::format("{} fields; a row needs {}", fields.size(), chosen + 1));
        const double wavelength = finite_number(lines, fields[0]);
        if (!wavelengths.empty() && !(wavelength > wavelengths.back()))
            lines.fail(fields[0], fmt::format("{} nm comes after {} nm; wavelengths must ascend",
                                              wavelength, wavelengths.back()));
        wavelengths.push_back(wavelength);
        values.push_back(finite_number(lines, fields[chosen]));
    }
    if (values.empty()) throw UsageError(fmt::format("{}: holds no spectrum", name));
    return Spectrum(name, std::move(wavelengths), std::move(values));
}

const std::string_view* find_data(std::string_view path)
{
    for (const EmbeddedFile& file : data_files())
        if (file.path.substr(root.size()) == path) return &file.text;
    return nullptr;
}

std::vector<std::string_view> data_paths(std::string_view folder)
{
    std::vector<std::string_view> paths;
    for (const EmbeddedFile& file : data_files()) {
        const std::string_view path = file.path.substr(root.size());
        if (path.starts_with(folder)) paths.push_back(path.substr(folder.size()));
    }
    return paths;
}

Spectrum built_in_spectrum(const std::string& path, std::string_view column)
{
    const std::string_view* text = find_data(path);
    if (!text) throw UsageError(fmt::format("there is no built-in spectrum `{}`", path));
    std::istringstream stream{std::string(*text)};
    return read_spectrum(stream, path, column);
}

}  // namespace gonio::skin
