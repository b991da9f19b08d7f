// SPDX-License-Identifier: Apache-2.0
// The kernel that integrates one lobe over the hemisphere for many cells at once.
#include "opencl/albedo_kernel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gonio/errors.hpp"
#include "grid/angles.hpp"
#include "opencl/buffers.hpp"
#include "opencl/table_program.hpp"
#include "quadrature/rules.hpp"

namespace gonio {
namespace {

/// Cells of one material side by side, a lane each. Its last group repeats its last cell.
struct Groups {
    std::vector<cl_uint> records;                 // [group][group field]
    std::vector<std::vector<std::size_t>> lanes;  // the cell of each lane
    std::size_t lines = 0;                        // of all groups
};

Groups groups_of(const AlbedoBatch& batch, unsigned width)
{
    Groups groups;
    for (std::size_t cell = 0; cell < batch.cells.size(); ++cell) {
        const bool fits =
            !groups.lanes.empty() && groups.lanes.back().size() < width &&
            batch.cells[groups.lanes.back().front()].material == batch.cells[cell].material;
        if (!fits) groups.lanes.emplace_back();
        groups.lanes.back().push_back(cell);
    }
    for (auto& lanes : groups.lanes) {
        lanes.resize(width, lanes.back());
        std::size_t count = 0;
        for (const std::size_t cell : lanes) count = std::max(count, batch.lines[cell].size());
        groups.records.push_back(static_cast<cl_uint>(batch.cells[lanes.front()].material));
        groups.records.push_back(static_cast<cl_uint>(groups.lines));
        groups.records.push_back(static_cast<cl_uint>(count));
        groups.lines += count;
    }
    return groups;
}

std::vector<float> cell_table(const AlbedoBatch& batch, const Groups& groups, unsigned width)
{
    std::vector<float> table(groups.lanes.size() * cell_fields * width);
    for (std::size_t g = 0; g < groups.lanes.size(); ++g)
        for (unsigned lane = 0; lane < width; ++lane) {
            const Incidence& at = batch.cells[groups.lanes[g][lane]].at;
            const auto put = [&](cell_field field, double value) {
                table[(g * cell_fields + field) * width + lane] = high_part(value);
            };
            put(cell_cos_hi, at.cosine);
            put(cell_cos_lo, at.cosine - static_cast<double>(high_part(at.cosine)));
            put(cell_sin, std::sqrt((1 - at.cosine) * (1 + at.cosine)));
            put(cell_cos_phi, cosine_of_degrees(at.phi));
            put(cell_sin_phi, sine_of_degrees(at.phi));
        }
    return table;
}

/// A lane with fewer lines than its group repeats its last one without weight.
std::vector<float> node_table(const AlbedoBatch& batch, const Groups& groups, unsigned width)
{
    std::vector<float> table(groups.lines * node_fields * width);
    for (std::size_t g = 0; g < groups.lanes.size(); ++g) {
        const std::size_t first = groups.records[g * group_fields + group_first];
        const std::size_t count = groups.records[g * group_fields + group_count];
        for (unsigned lane = 0; lane < width; ++lane) {
            const auto& lines = batch.lines[groups.lanes[g][lane]];
            for (std::size_t n = 0; n < count; ++n) {
                const AzimuthNode& node = lines[std::min(n, lines.size() - 1)];
                float* record = table.data() + (first + n) * node_fields * width + lane;
                const auto put = [&](node_field field, double value) {
                    record[std::size_t{field} * width] = high_part(value);
                };
                put(node_cos, node.cosine);
                put(node_sin, node.sine);
                put(node_frame_cos, node.frame_cosine);
                put(node_frame_sin, node.frame_sine);
                put(node_scale, node.scale);
                put(node_from, node.from);
                put(node_span, node.span);
                put(node_end, node.end);
                put(node_weight, n < lines.size() ? node.weight : 0);
            }
        }
    }
    return table;
}

std::vector<float> rule_table(int order)
{
    const reference::QuadratureRule& rule = rule_of(order);
    std::vector<float> table;
    for (Eigen::Index k = 0; k < rule.nodes.size(); ++k) {
        table.push_back(high_part(rule.nodes[k]));
        table.push_back(high_part(rule.weights[k]));
    }
    return table;
}

std::vector<float> all_parameters(const std::vector<Material>& materials)
{
    std::vector<float> values;
    for (const Material& material : materials) {
        const std::vector<float> numbers = parameter_values(material);
        values.insert(values.end(), numbers.begin(), numbers.end());
    }
    return values;
}

}  // namespace

AlbedoKernel::AlbedoKernel(Device::State& device, const std::vector<Material>& materials,
                           Fixed fixed)
    : device_(device),
      width_(device.width),
      channels_(materials.front().channels()),
      kernel_(albedo_kernel(device, materials.front(),
                            std::ranges::all_of(materials, &Material::isotropic))),
      parameters_(input_buffer(device, all_parameters(materials)))
{
    kernel_.setArg(1, parameters_);
    kernel_.setArg(2, static_cast<cl_uint>(parameter_values(materials.front()).size()));
    kernel_.setArg(9, static_cast<cl_int>(fixed == Fixed::viewer));
}

std::vector<std::vector<double>> AlbedoKernel::integrate(const AlbedoBatch& batch)
try {
    const Groups groups = groups_of(batch, width_);
    const std::size_t plane = groups.lanes.size() * width_;
    const cl::Buffer records(device_.context, groups.records.begin(), groups.records.end(), true);
    const cl::Buffer cells = input_buffer(device_, cell_table(batch, groups, width_));
    const cl::Buffer nodes = input_buffer(device_, node_table(batch, groups, width_));
    const cl::Buffer rule = input_buffer(device_, rule_table(batch.order));
    OutputBuffer out(device_, 2 * channels_ * plane);
    kernel_.setArg(0, out.buffer());
    kernel_.setArg(3, records);
    kernel_.setArg(4, cells);
    kernel_.setArg(5, nodes);
    kernel_.setArg(6, rule);
    kernel_.setArg(7, static_cast<cl_uint>(batch.order));
    kernel_.setArg(8, static_cast<cl_int>(batch.map));
    cl::Event event;
    device_.queue.enqueueNDRangeKernel(kernel_, cl::NullRange, cl::NDRange(groups.lanes.size()),
                                       cl::NullRange, nullptr, &event);
    out.map(2 * channels_ * plane);
    const float* values = out.wait();
    seconds_ += seconds_of(event);
    std::vector<std::vector<double>> result(channels_, std::vector<double>(batch.cells.size()));
    for (std::size_t c = 0; c < channels_; ++c)
        for (std::size_t g = 0; g < groups.lanes.size(); ++g)
            for (unsigned lane = 0; lane < width_; ++lane) {
                const float* high = values + 2 * c * plane + g * width_ + lane;
                result[c][groups.lanes[g][lane]] =
                    static_cast<double>(high[0]) + static_cast<double>(high[plane]);
            }
    out.unmap();
    out.check_canary();
    return result;
} catch (const cl::Error& error) {
    throw RunError(fmt::format("{} failed: {}", device_.info.name, error_text(error)));
}

}  // namespace gonio
