// SPDX-License-Identifier: Apache-2.0
// A page of a picture file: pixels for .png, shapes for .svg.
#pragma once

#include <filesystem>
#include <string>

#include "output/canvas.hpp"

namespace gonio {

class Page {
public:
    /// width, height: points. The name tells the format; throws UsageError for another one.
    Page(std::filesystem::path path, double width, double height);

    cairo_t* cairo() const { return context_.get(); }

    /// Writes the file in one step. Throws RunError, and leaves what was there, if anything failed.
    void save();

private:
    std::filesystem::path path_;
    std::string svg_;  // what the surface has written
    Surface surface_;
    Context context_;
};

}  // namespace gonio
