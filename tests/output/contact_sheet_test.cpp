// SPDX-License-Identifier: Apache-2.0
// Whole contact sheets from a device: size, labels, colours, the same bytes again, failures.
#include "output/contact_sheet.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gonio/errors.hpp"
#include "output/picture_fixtures.hpp"
#include "output/table_fixtures.hpp"

namespace gonio {
namespace {

using test::Picture;
using test::Pixel;

// Of the first card, in pixels.
constexpr int card_left = 25, card_right = 750, panel_right = 365, card_bottom = 365;
constexpr int sphere_x = 195, sphere_y = 195;

Material material(const std::string& model, const std::vector<double>& colour)
{
    Material made{"thing", {default_lobe(model)}};
    made.lobes[0].set(model == "lambert" ? "rho" : "f0", colour);
    return made;
}

class ContactSheet : public testing::Test {
protected:
    Picture draw(const std::vector<ContactCard>& cards)
    {
        write_contact_sheet(path, device, cards);
        return test::read_picture(path);
    }

    test::TemporaryDirectory directory;
    std::filesystem::path path = directory / "sheet.png";
    Device device;
    ContactCard red{material("lambert", {0.6, 0.05, 0.05}), "title", "subtitle"};
    ContactCard gold{material("ggx", {1, 0.77, 0.34}), "title", "subtitle"};
};

TEST_F(ContactSheet, ShowsEachMaterialInItsColours)
{
    const Picture sheet = draw({red, gold});
    const Pixel ball = sheet.at(sphere_x, sphere_y);
    EXPECT_GT(ball.red, 130);
    EXPECT_LT(ball.green, ball.red / 2);
    EXPECT_EQ(ball.green, ball.blue);
    const Pixel second = sheet.at(sphere_x - 40, sphere_y - 50 + card_bottom);
    EXPECT_GT(second.red, 200);
    EXPECT_GT(second.red, second.blue + 20);
    EXPECT_GE(second.red, second.green);

    const auto tinted = test::extent_of(sheet, [&](int x, int y) {
        const Pixel pixel = sheet.at(x, y);
        return x > panel_right && y < card_bottom && pixel.red > pixel.green + 25;
    });
    EXPECT_GT(tinted.count, 20000) << "the red lobe fills most of its half disc";
    EXPECT_LT(tinted.right, card_right);

    // The lobe of the second card leans to the right of the normal, where the mirror direction is.
    constexpr int plot_x = 557, plot_y = 682;
    EXPECT_GT(sheet.at(plot_x + 60, plot_y - 70).red, sheet.at(plot_x + 60, plot_y - 70).blue + 20);
    EXPECT_LT(sheet.at(plot_x - 60, plot_y - 70).red, sheet.at(plot_x - 60, plot_y - 70).blue + 20);
}

TEST_F(ContactSheet, HasACardForEachAndMoreColumnsForMany)
{
    const Picture one = draw({red}), two = draw({red, red}), four = draw({red, red, red, red});
    EXPECT_EQ(one.width, two.width);
    EXPECT_EQ(two.height - one.height, 365);
    EXPECT_EQ(four.width - one.width, 750);
    for (int x = card_left; x < card_right; x += 7)
        for (int y = 25; y < card_bottom; y += 7) {
            ASSERT_EQ(one.at(x, y), two.at(x, y + 365)) << x << ' ' << y;
            ASSERT_EQ(one.at(x, y), four.at(x + 750, y + 365)) << x << ' ' << y;
        }
}

TEST_F(ContactSheet, LabelsStandInTheirPlacesAndNowhereElse)
{
    const Picture sheet = draw({red});
    ContactCard renamed = red;
    renamed.title = "another name that is far too long for the card that it should stand on";
    const auto title = test::difference(sheet, draw({renamed}));
    EXPECT_GT(title.count, 500);
    EXPECT_GT(title.left, panel_right);
    EXPECT_LT(title.right, card_right - 20);
    EXPECT_LT(title.bottom, 75);

    ContactCard described = red;
    described.subtitle = "one line\nand another\n" + std::string(200, 'x') + "\nand a last one";
    const auto subtitle = test::difference(sheet, draw({described}));
    EXPECT_GT(subtitle.left, panel_right);
    EXPECT_LT(subtitle.right, card_right - 20);
    EXPECT_GT(subtitle.top, 75);
    EXPECT_LT(subtitle.bottom, 140);
    EXPECT_GT(subtitle.height(), 45);
}

TEST_F(ContactSheet, SameCardsGiveTheSameBytes)
{
    draw({red, gold});
    const std::string first = test::contents(path);
    draw({red, gold});
    EXPECT_EQ(test::contents(path), first);
}

TEST_F(ContactSheet, LeavesNothingBehindWhenItFails)
{
    EXPECT_THROW(write_contact_sheet(path, device, {}), UsageError);
    EXPECT_THROW(write_contact_sheet(directory / "none" / "sheet.png", device, {red}), RunError);
    red.title = "\xff is no UTF-8";
    EXPECT_THROW(write_contact_sheet(path, device, {red}), RunError);
    EXPECT_TRUE(std::filesystem::is_empty(directory.path()));
}

TEST(ContactCard, SaysModelsVariantsAndWhatIsNotDefault)
{
    const std::string nbsp = "\u00a0";
    Material steel{"steel", {default_lobe("lambert"), default_lobe("beckmann")}};
    steel.lobes[0].weight = {0.25};
    steel.lobes[1].set("f0", {0.9, 0.8, 0.7});
    steel.lobes[1].set("alpha", {0.3});
    const ContactCard card = make_card(steel);
    EXPECT_EQ(card.title, "steel");
    EXPECT_EQ(card.subtitle, "lambert: weight" + nbsp + "0.25\ntorrance_sparrow: ndf" + nbsp +
                                 "beckmann, masking" + nbsp + "height_correlated, fresnel" + nbsp +
                                 "schlick, f0" + nbsp + "(0.9," + nbsp + "0.8," + nbsp +
                                 "0.7), alpha" + nbsp + "0.3");

    Material brushed{"brushed", {default_lobe("ward")}};
    EXPECT_EQ(make_card(brushed).subtitle, "ward: form" + nbsp + "ward_1992");
    brushed.lobes[0].set("alpha_y", {0.4});
    EXPECT_EQ(make_card(brushed).subtitle,
              "ward: form" + nbsp + "ward_1992, alpha_y" + nbsp + "0.4");

    Material moon{"moon", {default_lobe("oren_nayar")}};
    moon.lobes[0].set("sigma", {30});
    EXPECT_EQ(make_card(moon).subtitle,
              "oren_nayar: form" + nbsp + "qualitative, sigma" + nbsp + "30°");
}

}  // namespace
}  // namespace gonio
