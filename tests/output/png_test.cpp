// SPDX-License-Identifier: Apache-2.0
// Pixels come back as they were written.
#include "output/png.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include "gonio/errors.hpp"
#include "output/table_fixtures.hpp"

namespace gonio {
namespace {

TEST(Png, KeepsPixels)
{
    test::TemporaryDirectory directory;
    const auto path = directory / "sheet.png";
    std::vector<std::uint8_t> pixels(std::size_t{3} * 5 * 4);
    for (std::size_t k = 0; k < pixels.size(); ++k) pixels[k] = static_cast<std::uint8_t>(4 * k);
    write_png(path, 5, 4, pixels);

    png_image image = {};
    image.version = PNG_IMAGE_VERSION;
    ASSERT_TRUE(png_image_begin_read_from_file(&image, path.c_str()));
    EXPECT_EQ(image.width, 5u);
    EXPECT_EQ(image.height, 4u);
    EXPECT_EQ(image.format, static_cast<png_uint_32>(PNG_FORMAT_RGB));
    std::vector<std::uint8_t> got(pixels.size());
    ASSERT_TRUE(png_image_finish_read(&image, nullptr, got.data(), 0, nullptr));
    EXPECT_EQ(got, pixels);
}

TEST(Png, RefusesAWrongNumberOfBytes)
{
    test::TemporaryDirectory directory;
    const std::vector<std::uint8_t> pixels(11);
    EXPECT_THROW(write_png(directory / "sheet.png", 2, 2, pixels), RunError);
}

}  // namespace
}  // namespace gonio
