// SPDX-License-Identifier: Apache-2.0
// Axes of a plot: from numbers to the page, with ticks at round numbers.
#pragma once

#include <string>
#include <vector>

#include "output/canvas.hpp"

namespace gonio {

/// From numbers to 0 … 1, linear, or logarithmic for numbers above 0.
class Scale {
public:
    Scale(double from, double to, bool logarithmic);
    /// Linear, of 1, 2, … with a name each.
    explicit Scale(std::vector<std::string> names);

    double operator()(double value) const;
    /// At most about ten numbers, and what to write there.
    std::vector<std::pair<double, std::string>> ticks() const;

private:
    double from_, to_;
    bool logarithmic_;
    std::vector<std::string> names_;
};

/// A rectangle of the page with a scale along each side; y goes up.
struct Axes {
    cairo_t* cairo;
    Box box;
    Scale across, up;

    double x(double value) const { return box.x + box.width * across(value); }
    double y(double value) const { return box.y + box.height * (1 - up(value)); }

    /// Lines at the ticks, their numbers, and what the axes are.
    void draw(const std::string& x_title, const std::string& y_title) const;
};

}  // namespace gonio
