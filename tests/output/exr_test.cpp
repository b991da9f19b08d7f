// SPDX-License-Identifier: Apache-2.0
// What is particular to EXR: halves, compressions, parts, attributes, and that stock tools read it.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gonio/errors.hpp"
#include "gonio/table.hpp"
#include "output/half_rounding.hpp"
#include "output/table_fixtures.hpp"

namespace gonio {
namespace {

using testing::HasSubstr;

class Exr : public testing::Test {
protected:
    test::TemporaryDirectory directory;
    std::filesystem::path path = directory / "table.exr";

    std::string text(int part, const char* attribute)
    {
        const Imf::MultiPartInputFile file(path.c_str());
        return file.header(part).typedAttribute<Imf::StringAttribute>(attribute).value();
    }
};

TEST_F(Exr, KeepsValuesInEveryCompressionAsFloatAndAsHalf)
{
    const auto table = test::filled(test::swept_header(), true);
    for (const auto* compression : {"none", "rle", "zips", "zip", "piz"}) {
        for (const bool half : {false, true}) {
            test::write_in_pieces(path, "exr", table, 4, {half, compression});
            EXPECT_EQ(read_table(path).values, table.values) << compression << ' ' << half;
        }
    }
}

TEST_F(Exr, LosesAsMuchInHalvesAsIsTold)
{
    Table table;
    table.header = test::small_header();
    table.values.resize(table.header.channels.size());
    double of_value = 0, of_small = 0;
    for (double scale = 1e-10; scale < 1e4; scale *= 4) {
        for (auto& plane : table.values) {
            plane.resize(table.header.cells());
            for (std::size_t k = 0; k < plane.size(); ++k)
                plane[k] = scale * std::pow(4, double(k) / double(plane.size()));
        }
        test::write_in_pieces(path, "exr", table, 4, {true, "none"});
        const Table got = read_table(path);
        for (std::size_t k = 0; k < table.values[0].size(); ++k) {
            const double value = double(float(table.values[0][k]));
            const double lost = std::abs(got.values[0][k] - value);
            if (value < half_rounding::least_normal)
                of_small = std::max(of_small, lost);
            else
                of_value = std::max(of_value, lost / value);
        }
    }
    EXPECT_LE(of_value, half_rounding::relative);
    EXPECT_GT(of_value, 0.8 * half_rounding::relative);
    EXPECT_LE(of_small, half_rounding::absolute);
    EXPECT_GT(of_small, 0.8 * half_rounding::absolute);
}

TEST_F(Exr, RoundsDoublesToFloats)
{
    auto header = test::small_header();
    header.single_precision = false;
    auto table = test::filled(header);
    write_table(path, "exr", table);
    const auto got = read_table(path);
    EXPECT_TRUE(got.header.single_precision);
    for (auto& value : table.values[1]) value = static_cast<float>(value);
    EXPECT_EQ(got.values[1], table.values[1]);
}

TEST_F(Exr, SaysInWordsWhichTexelIsWhich)
{
    write_table(path, "exr", test::filled(test::small_header()));
    EXPECT_EQ(text(0, "rows"), "theta_i (outer), theta_o");
    EXPECT_EQ(text(0, "columns"), "delta_phi");
    EXPECT_EQ(text(0, "quantity"), "brdf");
    EXPECT_EQ(text(0, "unit"), "1/sr");
    EXPECT_EQ(text(0, "axis.theta_i"), "5 cell centres, evenly spaced from 9 to 81 deg");
    EXPECT_EQ(text(0, "axis.theta_o"), "3 nodes at 0 0.1 90 deg");
    EXPECT_EQ(text(0, "attribute.model"), "ward");
    EXPECT_EQ(text(0, "attribute.rho_s"), "0.9 0.3333333333333333");
    EXPECT_THAT(text(0, "texels"), HasSubstr("(k + 0.5)/n"));
}

TEST_F(Exr, HasAPartForEachSweptValue)
{
    write_table(path, "exr", test::filled(test::swept_header()));
    const Imf::MultiPartInputFile file(path.c_str());
    ASSERT_EQ(file.parts(), 2);
    EXPECT_EQ(file.header(0).name(), "alpha=0.1");
    EXPECT_EQ(file.header(1).name(), "alpha=0.4");
    EXPECT_EQ(file.header(1).typedAttribute<Imf::DoubleAttribute>("sweep.alpha").value(), 0.4);
    EXPECT_EQ(file.header(1).dataWindow(), Imath::Box2i({0, 0}, {6, 14}));
    EXPECT_NE(file.header(1).channels().findChannel("brdf.G"), nullptr);
    EXPECT_EQ(text(1, "rows"), "theta_i (outer), theta_o");
}

TEST_F(Exr, RefusesAPeakThatNoHalfHolds)
{
    auto table = test::filled(test::small_header());
    table.values[1][20] = 70000;
    try {
        write_table(path, "exr", table, {true, "zip"});
        ADD_FAILURE() << "written";
    } catch (const RunError& fault) {
        EXPECT_THAT(fault.what(), HasSubstr("70000 in row 2 is beyond the largest half, 65504"));
    }
}

TEST_F(Exr, RefusesWhatItCannotHold)
{
    auto header = test::small_header();
    EXPECT_THROW(make_writer(path, "exr", header, {false, "dwaa"}), UsageError);
    auto& axis = header.axes[1];
    axis.values.clear();
    for (int k = 0; k < 1 << 20; ++k) axis.values.push_back(k);
    EXPECT_NO_THROW(make_writer(path, "exr", header));
    header.sweep_axes = 2;  // 5 million parts
    EXPECT_THROW(make_writer(path, "exr", header), UsageError);
    header.sweep_axes = 0;
    header.axes[0] = axis;
    header.axes[0].name = "theta_i";  // 2^40 rows
    EXPECT_THROW(make_writer(path, "exr", header), UsageError);
}

TEST_F(Exr, RefusesFilesOfOthers)
{
    {
        Imf::Header header(1, 1);
        header.channels().insert("R", Imf::Channel(Imf::FLOAT));
        Imf::OutputFile file(path.c_str(), header);
        const float pixel = 1;
        Imf::FrameBuffer frame;
        frame.insert("R", Imf::Slice::Make(Imf::FLOAT, &pixel, header.dataWindow()));
        file.setFrameBuffer(frame);
        file.writePixels(1);
    }
    EXPECT_THROW(read_table(path), UsageError);
}

TEST_F(Exr, IsReadByStockTools)
{
    write_table(path, "exr", test::filled(test::swept_header()));
    const auto header = test::output_of("exrheader " + path.string());
    EXPECT_THAT(header, HasSubstr("part 1:"));
    EXPECT_THAT(header, HasSubstr("brdf.G, 32-bit floating-point"));
    EXPECT_THAT(header, HasSubstr("rows (type string): \"theta_i (outer), theta_o\""));
    EXPECT_THAT(test::output_of("exrinfo -s -v " + path.string()), HasSubstr("alpha=0.4"));
}

}  // namespace
}  // namespace gonio
