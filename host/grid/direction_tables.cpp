// SPDX-License-Identifier: Apache-2.0
// The tables that a grid's kernel reads, made in double.
#include "grid/direction_tables.hpp"

#include <algorithm>
#include <cmath>

#include "gonio/shared/grid_fields.h"
#include "grid/pairs.hpp"

namespace gonio {
namespace {

std::vector<PolarAngle> polar_angles(const Axis& axis)
{
    return {axis.values.begin(), axis.values.end()};
}

std::vector<float> theta_table(const std::vector<PolarAngle>& incoming,
                               const std::vector<PolarAngle>& outgoing)
{
    std::vector<float> table(incoming.size() * outgoing.size() * theta_fields);
    float* record = table.data();
    for (const PolarAngle& i : incoming)
        for (const PolarAngle& o : outgoing) {
            const PolarPair pair(i, o);
            record[theta_cos_i] = high_part(i.cosine);
            record[theta_cos_o] = high_part(o.cosine);
            record[theta_cos_i_lo] = low_part(i.cosine);
            record[theta_cos_o_lo] = low_part(o.cosine);
            record[theta_sin_i] = high_part(i.sine);
            record[theta_sin_o] = high_part(o.sine);
            record[theta_tan2_half_difference] = high_part(pair.tan2_half_difference);
            record[theta_tan2_half_sum] = high_part(pair.tan2_half_sum);
            record[theta_cos2_half_sum] = high_part(pair.cos2_half_sum);
            record[theta_sin2_half_difference] = high_part(pair.sin2_half_difference);
            record[theta_cos_cos_hi] = high_part(pair.cos_cos);
            record[theta_cos_cos_lo] = low_part(pair.cos_cos);
            record[theta_sin_sin_hi] = high_part(pair.sin_sin);
            record[theta_sin_sin_lo] = low_part(pair.sin_sin);
            record += theta_fields;
        }
    return table;
}

std::vector<float> phi_table(const std::vector<double>& incoming,
                             const std::vector<double>& outgoing)
{
    const std::size_t length = outgoing.size();
    std::vector<float> table(incoming.size() * phi_fields * length);
    for (std::size_t a = 0; a < incoming.size(); ++a)
        for (std::size_t b = 0; b < length; ++b) {
            float* run = table.data() + a * phi_fields * length + b;
            const AzimuthPair pair(outgoing[b] - incoming[a]);
            run[phi_cos2_half_delta * length] = high_part(pair.cos2_half);
            run[phi_sin2_half_delta * length] = high_part(pair.sin2_half);
            run[phi_cos_delta_hi * length] = high_part(pair.cosine);
            run[phi_cos_delta_lo * length] = low_part(pair.cosine);
        }
    return table;
}

/// x and y of unit vectors; `stride` is the distance between two fields of one direction.
void put_tangent(float* field, std::size_t stride, const PolarAngle& theta, double phi)
{
    const double x = theta.sine * cosine_of_degrees(phi), y = theta.sine * sine_of_degrees(phi);
    field[tangent_x_hi * stride] = high_part(x);
    field[tangent_x_lo * stride] = low_part(x);
    field[tangent_y_hi * stride] = high_part(y);
    field[tangent_y_lo * stride] = low_part(y);
}

DirectionTables spherical_tables(const Grid& grid, bool tangents)
{
    const bool isotropic = grid.kind == GridKind::isotropic;
    const std::vector<PolarAngle> theta_i = polar_angles(grid.axes[0]);
    const std::vector<PolarAngle> theta_o = polar_angles(grid.axes[isotropic ? 1 : 2]);
    const std::vector<double> phi_i = isotropic ? std::vector<double>{0.0} : grid.axes[1].values;
    const std::vector<double>& phi_o = grid.axes.back().values;

    // Without a tangent frame the kernel does not read the last two; a buffer of nothing does not
    // exist in OpenCL.
    std::vector<float> in(1), out(1);
    if (tangents) {
        in.resize(theta_i.size() * phi_i.size() * tangent_fields);
        float* record = in.data();
        for (const PolarAngle& theta : theta_i)
            for (const double phi : phi_i) {
                put_tangent(record, 1, theta, phi);
                record += tangent_fields;
            }
        out.resize(theta_o.size() * phi_o.size() * tangent_fields);
        for (std::size_t o = 0; o < theta_o.size(); ++o)
            for (std::size_t b = 0; b < phi_o.size(); ++b)
                put_tangent(out.data() + o * tangent_fields * phi_o.size() + b, phi_o.size(),
                            theta_o[o], phi_o[b]);
    }
    return {"directions/spherical.cl",
            {theta_table(theta_i, theta_o), phi_table(phi_i, phi_o), std::move(in), std::move(out)},
            {static_cast<unsigned>(phi_i.size()), static_cast<unsigned>(theta_o.size())},
            phi_o.size(),
            theta_i.size() * phi_i.size() * theta_o.size()};
}

DirectionTables rusinkiewicz_tables(const Grid& grid)
{
    std::vector<float> halves(grid.axes[0].values.size() * grid.axes[1].values.size() *
                              half_fields);
    float* record = halves.data();
    for (const double theta_h : grid.axes[0].values)
        for (const double theta_d : grid.axes[1].values) {
            const PolarAngle h(theta_h), d(theta_d);
            const double cos_cos = h.cosine * d.cosine, sin_sin = h.sine * d.sine;
            const double tan_h = h.sine / h.cosine;
            const double l_v = (d.cosine - d.sine) * (d.cosine + d.sine);
            record[half_sin_h] = high_part(h.sine);
            record[half_cos_h] = high_part(h.cosine);
            record[half_sin_d] = high_part(d.sine);
            record[half_cos_d] = high_part(d.cosine);
            record[half_tan2_h] = high_part(tan_h * tan_h);
            record[half_cos_cos_hi] = high_part(cos_cos);
            record[half_cos_cos_lo] = low_part(cos_cos);
            record[half_sin_sin_hi] = high_part(sin_sin);
            record[half_sin_sin_lo] = low_part(sin_sin);
            record[half_l_v_hi] = high_part(l_v);
            record[half_l_v_lo] = low_part(l_v);
            record += half_fields;
        }
    const std::vector<double>& phi_d = grid.axes[2].values;
    const std::size_t length = phi_d.size();
    std::vector<float> differences(length * difference_fields);
    for (std::size_t k = 0; k < length; ++k) {
        const double cosine = cosine_of_degrees(phi_d[k]);
        differences[difference_cos_hi * length + k] = high_part(cosine);
        differences[difference_cos_lo * length + k] = low_part(cosine);
        differences[difference_sin * length + k] = high_part(sine_of_degrees(phi_d[k]));
    }
    return {"directions/rusinkiewicz.cl",
            {std::move(halves), std::move(differences)},
            {},
            length,
            grid.axes[0].values.size() * grid.axes[1].values.size()};
}

}  // namespace

DirectionTables direction_tables(const Grid& grid, bool tangents)
{
    return grid.kind == GridKind::rusinkiewicz ? rusinkiewicz_tables(grid)
                                               : spherical_tables(grid, tangents);
}

DirectionTables direction_tables(const std::vector<DirectionPair>& points)
{
    const std::size_t length = points.size();
    std::vector<float> table(length * point_fields);
    for (std::size_t k = 0; k < length; ++k) {
        const PolarAngle i(points[k].theta_i), o(points[k].theta_o);
        const PolarPair polar(i, o);
        const AzimuthPair azimuth(points[k].phi_o - points[k].phi_i);
        const auto [l, v] = unit_vectors(points[k]);
        const auto put = [&](point_field field, double value) {
            table[field * length + k] = high_part(value);
        };
        const auto put_both = [&](point_field high, point_field low, double value) {
            put(high, value);
            put(low, value - static_cast<double>(high_part(value)));
        };
        put_both(point_cos_i, point_cos_i_lo, i.cosine);
        put_both(point_cos_o, point_cos_o_lo, o.cosine);
        put(point_sin_i, i.sine);
        put(point_sin_o, o.sine);
        put(point_tan2_h, polar.tan2_half_difference * azimuth.sin2_half +
                              polar.tan2_half_sum * azimuth.cos2_half);
        put(point_cos2_d, polar.cos2_half_sum + polar.sin_sin * azimuth.cos2_half);
        put(point_sin2_d, polar.sin2_half_difference + polar.sin_sin * azimuth.sin2_half);
        put(point_mirror, 2 * (polar.sin2_half_difference + polar.sin_sin * azimuth.cos2_half));
        put(point_cos_r, polar.cos_cos - polar.sin_sin * azimuth.cosine);
        put_both(point_cos_cos_hi, point_cos_cos_lo, polar.cos_cos);
        put_both(point_tangent_hi, point_tangent_lo, polar.sin_sin * azimuth.cosine);
        put(point_cos_phi, azimuth.cosine);
        put(point_out_of_plane, 2 * std::min(azimuth.sin2_half, azimuth.cos2_half));
        put(point_slope_x, (l.x + v.x) / (l.z + v.z));
        put(point_slope_y, (l.y + v.y) / (l.z + v.z));
        put(point_x_i, l.x);
        put(point_y_i, l.y);
        put(point_x_o, v.x);
        put(point_y_o, v.y);
        put_both(point_x_x_hi, point_x_x_lo, l.x * v.x);
        put_both(point_y_y_hi, point_y_y_lo, l.y * v.y);
    }
    return {"directions/points.cl", {std::move(table)}, {}, length, 1};
}

}  // namespace gonio
