// SPDX-License-Identifier: Apache-2.0
// MERL's .binary (Matusik et al. 2003): three int32 sizes (theta_h, theta_d, phi_d), then a plane
// of doubles each for red, green and blue, phi_d innermost, divided by a scale factor; -1 where
// light or viewer are below the horizon. Our other facts (unit, attributes) are in the sidecar.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "gonio/errors.hpp"
#include "grid/rusinkiewicz.hpp"
#include "output/check.hpp"
#include "output/formats.hpp"
#include "output/plane_file.hpp"
#include "output/rows.hpp"
#include "output/sidecar.hpp"

namespace gonio {
namespace {

using Sizes = std::array<std::int32_t, 3>;  // theta_h, theta_d, phi_d

constexpr Sizes standard_sizes = {90, 90, 180};
constexpr std::array<double, 3> scales = {1.0 / 1500, 1.15 / 1500, 1.66 / 1500};
constexpr double invalid = -1;
constexpr double angle_tolerance = 1e-6;  // degree

Axis axis_of(const std::string& name, std::int32_t count, double range, double power)
{
    Axis axis{name, "deg", {}, Samples::centre};
    for (std::int32_t k = 0; k < count; ++k) {
        axis.values.push_back(range * std::pow((k + 0.5) / count, power));
    }
    return axis;
}

/// Bin centres; the bins of theta_h are even in its square root.
std::vector<Axis> axes_of(const Sizes& sizes)
{
    return {axis_of("theta_h", sizes[0], 90, 2), axis_of("theta_d", sizes[1], 90, 1),
            axis_of("phi_d", sizes[2], 180, 1)};
}

bool agree(const Axis& a, const Axis& b)
{
    if (a.name != b.name || a.unit != b.unit || a.samples != b.samples) return false;
    return std::equal(a.values.begin(), a.values.end(), b.values.begin(), b.values.end(),
                      [](double x, double y) { return std::abs(x - y) <= angle_tolerance; });
}

bool holds(const Sizes& sizes, const TableHeader& header)
{
    const auto axes = axes_of(sizes);
    return (header.channels.size() == 1 || header.channels.size() == scales.size()) &&
           std::equal(axes.begin(), axes.end(), header.axes.begin(), header.axes.end(), agree);
}

void require_standard(const TableHeader& header)
{
    if (holds(standard_sizes, header)) return;
    throw UsageError(fmt::format(
        "a MERL file holds 90 x 90 x 180 values over theta_h, theta_d, phi_d in degrees (a "
        "Rusinkiewicz grid with MERL's spacing, samples at centres) of 1 or 3 channels; this table "
        "has {} values of {} channels, or other axes",
        shape_text(header), header.channels.size()));
}

PlaneLayout layout_of(const Sizes& sizes)
{
    const auto size = [&](std::size_t k) { return static_cast<std::uint64_t>(sizes[k]); };
    return {sizeof(Sizes), sizeof(double), size(2), size(0) * size(1), scales.size()};
}

class MerlFormat {
public:
    MerlFormat(const TableHeader& header, const std::filesystem::path& path)
        : header_(header), layout_(layout_of(standard_sizes)), file_(path)
    {
        file_.write(standard_sizes.data(), sizeof(standard_sizes));
    }

    /// A table of one channel is written to all three planes.
    template <class Real>
    void put(const Rows<Real>& rows)
    {
        std::vector<double> stored(rows.count * header_.row_length());
        for (std::size_t p = 0; p < scales.size(); ++p) {
            const Real* values = rows.planes[p % rows.planes.size()];
            for (std::size_t k = 0; k < stored.size(); ++k) {
                stored[k] = is_invalid(rows.first, k, values[k])
                                ? invalid
                                : static_cast<double>(values[k]) / scales[p];
            }
            write_plane_rows(file_, layout_, p, rows.first, rows.count, stored.data());
        }
    }

    void finish()
    {
        write_sidecar(file_.path(), header_);
        file_.commit();
    }

private:
    template <class Real>
    bool is_invalid(std::size_t first_row, std::size_t k, Real value) const
    {
        const auto row = first_row + k / header_.row_length();
        const auto differences = header_.axes[1].values.size();
        return std::isnan(value) ||
               is_below_horizon(header_.axes[0].values[row / differences],
                                header_.axes[1].values[row % differences],
                                header_.axes[2].values[k % header_.row_length()]);
    }

    TableHeader header_;
    PlaneLayout layout_;
    AtomicFile file_;
};

std::optional<Sizes> sizes_in(const std::filesystem::path& path)
{
    constexpr std::int32_t largest = 1 << 16;  // text and other formats have larger numbers here
    Sizes sizes = {};
    std::ifstream file(path, std::ios::binary);
    file.read(reinterpret_cast<char*>(sizes.data()), sizeof(sizes));
    for (const auto size : sizes) {
        if (!file || size < 1 || size > largest) return std::nullopt;
    }
    return sizes;
}

/// The header in the sidecar if that describes this file, else what all MERL files share.
TableHeader header_of(const std::filesystem::path& path, const Sizes& sizes)
{
    if (const auto header = read_sidecar(path); header && holds(sizes, *header)) return *header;
    TableHeader header;
    header.quantity = "brdf";
    header.unit = "1/sr";
    header.axes = axes_of(sizes);
    header.channels = {"R", "G", "B"};
    header.single_precision = false;
    return header;
}

class MerlReader final : public TableReader {
public:
    MerlReader(const std::filesystem::path& path, const Sizes& sizes)
        : planes_(path, layout_of(sizes)), header_(header_of(path, sizes))
    {
    }

    const TableHeader& header() const override { return header_; }

    /// A negative number in the file means that there is no value: NaN here.
    void read(std::size_t count, const std::vector<double*>& planes) override
    {
        for (std::size_t c = 0; c < planes.size(); ++c) {
            planes_.read(c, next_, count, planes[c]);
            for (std::size_t k = 0; k < count * header_.row_length(); ++k) {
                double& value = planes[c][k];
                value = value < 0 ? std::numeric_limits<double>::quiet_NaN() : value * scales[c];
                if (header_.single_precision) value = static_cast<float>(value);
            }
        }
        next_ += count;
    }

private:
    PlaneReader planes_;
    TableHeader header_;
    std::size_t next_ = 0;
};

}  // namespace

std::unique_ptr<TableWriter> make_merl_writer(const std::filesystem::path& path,
                                              const TableHeader& header)
{
    require_standard(header);
    return std::make_unique<OrderedWriter<MerlFormat>>(header, path);
}

bool is_merl(const std::filesystem::path& path)
{
    return sizes_in(path).has_value();
}

std::unique_ptr<TableReader> open_merl(const std::filesystem::path& path)
{
    return std::make_unique<MerlReader>(path, sizes_in(path).value());
}

}  // namespace gonio
