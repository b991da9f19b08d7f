// SPDX-License-Identifier: Apache-2.0
// Colours of measured reflectances.
#include "gonio/colour.hpp"

#include <gtest/gtest.h>

#include "gonio/errors.hpp"
#include "reference/csv.hpp"

namespace gonio {
namespace {

using test::CsvRow;
using test::read_csv;

std::vector<double> column(const std::vector<CsvRow>& rows, const std::string& name)
{
    std::vector<double> numbers;
    for (const CsvRow& row : rows) numbers.push_back(row.number(name));
    return numbers;
}

// XYZ and sRGB of the mean spectrum were computed for this project by another program from the data
// of Cooksey, Allen and Tsai 2017.
TEST(Colours, MeanSkinOfNist)
{
    const auto rows = read_csv("skin/nist.csv");
    const auto colour = colour_of(column(rows, "wavelength"), column(rows, "mean"));
    EXPECT_NEAR(colour.xyz.x, 36.91, 0.005);
    EXPECT_NEAR(colour.xyz.y, 35.91, 0.005);
    EXPECT_NEAR(colour.xyz.z, 27.96, 0.005);
    EXPECT_EQ(colour.srgb, glm::ivec3(188, 155, 135));
}

TEST(Colours, HundredPeopleOfNist)
{
    const auto rows = read_csv("skin/nist.csv");
    const auto wavelengths = column(rows, "wavelength");
    const auto people = read_csv("skin/nist_colours.csv");
    ASSERT_EQ(people.size(), 100U);
    for (const CsvRow& person : people) {
        const auto colour = colour_of(wavelengths, column(rows, "s" + person.text("subject")));
        EXPECT_NEAR(colour.lab.x, person.number("L"), 6e-4) << person.text("subject");
        EXPECT_NEAR(colour.lab.y, person.number("a"), 6e-4) << person.text("subject");
        EXPECT_NEAR(colour.lab.z, person.number("b"), 6e-4) << person.text("subject");
        EXPECT_NEAR(colour.typology_angle, person.number("ITA_deg"), 6e-3)
            << person.text("subject");
    }
}

// The white of the sum over 5 nm is X 95.04297, Z 108.88005; CIE 15 prints 95.047 and 108.883 for
// sums over 1 nm.
TEST(Colours, WhiteIsWhite)
{
    std::vector<double> wavelengths;
    for (int at = 380; at <= 780; at += 20) wavelengths.push_back(at);
    const auto white = colour_of(wavelengths, std::vector<double>(wavelengths.size(), 1));
    EXPECT_NEAR(white.xyz.x, 95.04297, 5e-6);
    EXPECT_NEAR(white.xyz.y, 100, 1e-12);
    EXPECT_NEAR(white.xyz.z, 108.88005, 5e-6);
    EXPECT_NEAR(white.lab.x, 100, 1e-12);
    EXPECT_NEAR(white.lab.y, 0, 1e-12);
    EXPECT_EQ(white.srgb, glm::ivec3(255, 255, 255));
    wavelengths.erase(wavelengths.begin() + 5);
    EXPECT_FALSE(has_colour(wavelengths));
    EXPECT_THROW(colour_of({400, 780}, {1, 1}), UsageError);
}

}  // namespace
}  // namespace gonio
