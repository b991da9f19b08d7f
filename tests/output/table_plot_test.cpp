// SPDX-License-Identifier: Apache-2.0
// Pictures of tables: where curves, bands and cells are.
#include "output/table_plot.hpp"

#include <gtest/gtest.h>

#include "gonio/errors.hpp"
#include "output/picture_fixtures.hpp"
#include "output/plot_axes.hpp"
#include "output/table_fixtures.hpp"

namespace gonio::test {
namespace {

Table table_of(std::vector<Axis> axes, std::vector<std::vector<double>> values)
{
    Table table;
    table.header.quantity = "reflectance_r";
    table.header.unit = "1/cm^2";
    table.header.axes = std::move(axes);
    table.header.channels = {"Y"};
    if (values.size() == 2) table.header.channels.push_back("Y.error");
    table.values = std::move(values);
    return table;
}

Picture plotted(const Table& table)
{
    const TemporaryDirectory directory;
    write_table_plot(directory / "plot.png", table);
    return read_picture(directory / "plot.png");
}

/// Rows of the picture that the curve of the first channel, or its band, covers in a column.
Extent covered(const Picture& picture, int column)
{
    return extent_of(picture, [&](int x, int y) {
        const Pixel pixel = picture.at(x, y);
        return x == column && y > picture.height * 70 / 420 && pixel.blue > pixel.red + 10;
    });
}

TEST(TablePlot, ShowsErrorsAsABand)
{
    const Axis r{"r", "cm", {0.5, 1.5, 2.5}};
    const Picture sharp = plotted(table_of({r}, {{1, 1, 1}, {0, 0, 0}}));
    const Picture wide = plotted(table_of({r}, {{1, 1, 1}, {0, 0.3, 0}}));
    const int middle = sharp.width * (72 + 270) / 640;
    EXPECT_LT(covered(sharp, middle).height(), sharp.height / 50);
    // 0.3 of an axis from 0 to 1 below the line; what is above is cut off.
    EXPECT_NEAR(covered(wide, middle).height(), 0.3 * 290 / 420 * wide.height, wide.height / 50);
}

TEST(TablePlot, MapsValuesToColours)
{
    const Axis z{"z", "cm", {0.5, 1.5}}, r{"r", "cm", {0.5, 1.5}};
    const Picture picture = plotted(table_of({z, r}, {{1, 10, 100, 1000}}));
    const auto brightness = [&](double across, double down) {
        const Pixel pixel = picture.at(int(picture.width * (72 + across * 440) / 640),
                                       int(picture.height * (74 + down * 290) / 420));
        return pixel.red + pixel.green + pixel.blue;
    };
    EXPECT_LT(brightness(0.25, 0.25), brightness(0.75, 0.25));
    EXPECT_LT(brightness(0.75, 0.25), brightness(0.25, 0.75));  // the outer axis goes down
    EXPECT_LT(brightness(0.25, 0.75), brightness(0.75, 0.75));
}

TEST(TablePlot, RefusesOtherShapes)
{
    const TemporaryDirectory directory;
    EXPECT_THROW(write_table_plot(directory / "plot.png", filled(small_header())), UsageError);
    EXPECT_THROW(
        write_table_plot(directory / "plot.gif", table_of({{"r", "cm", {0.5, 1.5}}}, {{1, 2}})),
        UsageError);
}

TEST(Scale, HasRoundTicks)
{
    const auto texts = [](const Scale& scale) {
        std::string all;
        for (const auto& [value, text] : scale.ticks()) all += text + ' ';
        return all;
    };
    EXPECT_EQ(texts({0, 0.5, false}), "0 0.05 0.1 0.15 0.2 0.25 0.3 0.35 0.4 0.45 0.5 ");
    EXPECT_EQ(texts({-0.3, 47, false}), "0 5 10 15 20 25 30 35 40 45 ");
    EXPECT_EQ(texts({0.02, 300, true}), "0.1 1 10 100 ");
    EXPECT_EQ(texts({2, 2, false}), "1.5 1.6 1.7 1.8 1.9 2 2.1 2.2 2.3 2.4 2.5 ");
    EXPECT_DOUBLE_EQ(Scale(1, 100, true)(10), 0.5);
}

}  // namespace
}  // namespace gonio::test
