// SPDX-License-Identifier: Apache-2.0
// What benchmarks found: plots of points, each with the spread of its measurements.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace gonio {

/// The median of measurements and the quartiles around it.
struct Quartiles {
    double median = 0, low = 0, high = 0;
};

/// Of what is known without measuring.
inline Quartiles exactly(double value)
{
    return {value, value, value};
}

/// Measurements are not empty.
Quartiles quartiles_of(std::vector<double> measurements);

struct BenchPoint {
    std::string series;  ///< points of one are joined by a line
    std::string label;   ///< what tells it from the others of its series
    Quartiles x, y;
    bool best = false;  ///< no other point of the plot has both a smaller x and a smaller y
    std::map<std::string, double> more = {};  ///< further numbers by name
};

struct BenchPlot {
    std::string id, title, note;
    std::string x_title, y_title;
    bool x_logarithmic = true, y_logarithmic = true;
    bool joined = true;
    std::vector<std::string> x_names = {};  ///< of x = 1, 2, …, where those are no quantities
    std::vector<BenchPoint> points = {};
};

/// Marks the points that no other beats in both x and y. One without an error is what the others
/// are measured against, and does not take part.
void mark_best(BenchPlot& plot);

struct BenchReport {
    nlohmann::ordered_json about;  ///< program, device, driver, flags, clock, noise
    std::vector<BenchPlot> plots;
};

nlohmann::ordered_json json_of(const BenchReport& report);

/// Reads a results.json, or the one in a folder. Throws UsageError for any other file.
BenchReport read_report(const std::filesystem::path& path);

/// Writes report.html, results.json, results.csv, and each plot as .svg and .png.
void write_report(const std::filesystem::path& directory, const BenchReport& report);

/// Draws one plot; the name tells the format, .svg or .png.
void write_bench_plot(const std::filesystem::path& path, const BenchPlot& plot);

/// A text of what two reports have in common: the ratios of their times and errors, and which of
/// them are beyond the spread of the measurements.
std::string comparison(const BenchReport& first, const BenchReport& second);

}  // namespace gonio
