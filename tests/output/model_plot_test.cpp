// SPDX-License-Identifier: Apache-2.0
// The page about a material: both formats, the same bytes again, what is on it, failures.
#include "output/model_plot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gonio/errors.hpp"
#include "output/picture_fixtures.hpp"
#include "output/table_fixtures.hpp"

namespace gonio {
namespace {

using test::Picture;
using testing::HasSubstr;
using testing::StartsWith;

class ModelPlot : public testing::Test {
protected:
    Picture draw(const Material& material)
    {
        write_model_plot(path, material);
        return test::read_picture(path);
    }

    test::TemporaryDirectory directory;
    std::filesystem::path path = directory / "plot.png";
    Material grey{"lambert", {default_lobe("lambert")}};
};

TEST_F(ModelPlot, FillsFourHalfDiscsWithADiffuser)
{
    const Picture page = draw(grey);
    const auto filled = test::extent_of(page, [&](int x, int y) {
        const auto pixel = page.at(x, y);
        return pixel.blue > pixel.red + 15 && pixel.red < 225;
    });
    // Four of pi r^2 / 2 with r = 140 points at 1.5 pixels; labels and rings lie on them.
    EXPECT_NEAR(filled.count, 2 * 3.1416 * 210 * 210, 0.04 * 2 * 3.1416 * 210 * 210);
}

TEST_F(ModelPlot, DrawsTheAlbedoOfEachChannel)
{
    Material coloured = grey;
    coloured.lobes[0].set("rho", std::vector{0.3, 0.5, 0.9});
    const Picture page = draw(coloured);
    const int left = 1040, right = page.width - 40;
    const auto line = [&](auto is_colour) {
        return test::extent_of(page, [&](int x, int y) {
            return x > left && x < right && y > 140 && is_colour(page.at(x, y));
        });
    };
    const auto red = line([](auto p) { return p.red > p.green + 80 && p.red > p.blue + 80; });
    const auto green = line([](auto p) { return p.green > p.red + 60 && p.green > p.blue + 40; });
    const auto blue = line([](auto p) { return p.blue > p.red + 100; });
    // A line is level, and their heights are in proportion.
    for (const auto& extent : {red, green, blue}) EXPECT_LE(extent.height(), 4);
    EXPECT_NEAR((red.top - green.top) / static_cast<double>(red.top - blue.top), 0.2 / 0.6, 0.02);
}

TEST_F(ModelPlot, SvgHoldsShapesAndComesOutTheSame)
{
    const auto svg = directory / "plot.svg";
    write_model_plot(svg, grey);
    const std::string text = test::contents(svg);
    EXPECT_THAT(text, StartsWith("<?xml"));
    EXPECT_THAT(text, HasSubstr("</svg>"));
    EXPECT_THAT(text, testing::Not(HasSubstr("<image")));
    EXPECT_GT(text.size(), 20000U);
    draw(grey);
    const std::string first = test::contents(path);
    draw(grey);
    EXPECT_EQ(test::contents(path), first);
}

TEST_F(ModelPlot, DrawsEveryModel)
{
    for (const Model& model : models()) {
        const std::string id(model.id);
        write_model_plot(directory / (id + ".svg"), Material{id, {default_lobe(id)}});
        const std::string text = test::contents(directory / (id + ".svg"));
        EXPECT_EQ(text.find("nan"), std::string::npos) << id;
        EXPECT_EQ(text.find("inf"), std::string::npos) << id;
    }
}

TEST_F(ModelPlot, LeavesNothingBehindWhenItFails)
{
    EXPECT_THROW(write_model_plot(directory / "plot.pdf", grey), UsageError);
    EXPECT_THROW(write_model_plot(directory / "none" / "plot.svg", grey), RunError);
    EXPECT_THROW(write_model_plot(directory / "none" / "plot.png", grey), RunError);
    EXPECT_TRUE(std::filesystem::is_empty(directory.path()));
}

}  // namespace
}  // namespace gonio
