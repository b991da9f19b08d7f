// SPDX-License-Identifier: Apache-2.0
// Runs the samplers of a material's lobes, and their density, on a device.
#include "gonio/sampling.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "gonio/errors.hpp"
#include "gonio/shared/sample_fields.h"
#include "grid/angles.hpp"
#include "opencl/buffers.hpp"
#include "opencl/table_program.hpp"

namespace gonio {
namespace {

void check_sampled(const Material& material)
{
    std::vector<std::string_view> sampled;
    for (const Model& model : models())
        if ((model.traits & SAMPLED) != 0) sampled.push_back(model.id);
    for (const Lobe& lobe : material.lobes)
        if ((lobe.traits() & SAMPLED) == 0)
            throw UsageError(fmt::format("model `{}` cannot be sampled; those that can: {}",
                                         lobe.model->id, fmt::join(sampled, ", ")));
}

/// A kernel of sample.cl with the arguments that both of them have.
class SamplingKernel {
public:
    SamplingKernel(const Device& device, const Material& material, const Incidence& light,
                   const char* name)
        : device_(device.state())
    {
        check_sampled(material);
        kernel_ = sampling_kernel(device_, material, name);
        parameters_ = input_buffer(device_, parameter_values(material));
        light_ =
            input_buffer(device_, {high_part(light.cosine), low_part(light.cosine),
                                   high_part(std::sqrt((1 - light.cosine) * (1 + light.cosine))),
                                   high_part(cosine_of_degrees(light.phi)),
                                   high_part(sine_of_degrees(light.phi))});
        kernel_.setArg(1, parameters_);
        kernel_.setArg(2, light_);
    }

    template <class Value>
    void set(cl_uint argument, const Value& value)
    {
        kernel_.setArg(argument, value);
    }

    /// The length of a plane of `count` numbers in whole vectors.
    std::size_t plane_of(std::size_t count) const
    {
        return (count + device_.width - 1) / device_.width * device_.width;
    }

    /// [plane][number]
    std::vector<float> run(std::size_t planes, std::size_t plane)
    {
        OutputBuffer out(device_, planes * plane);
        kernel_.setArg(0, out.buffer());
        // PoCL compiles a kernel anew for every size of its work-groups.
        const bool cpu = device_.info.type == "CPU";
        device_.queue.enqueueNDRangeKernel(kernel_, cl::NullRange,
                                           cl::NDRange(plane / device_.width),
                                           cpu ? cl::NDRange(1) : cl::NullRange);
        out.map(planes * plane);
        const float* values = out.wait();
        std::vector<float> result(values, values + planes * plane);
        out.unmap();
        out.check_canary();
        return result;
    }

private:
    Device::State& device_;
    cl::Kernel kernel_;
    cl::Buffer parameters_, light_;
};

[[noreturn]] void fail(const Device& device, const cl::Error& error)
{
    throw RunError(fmt::format("{} failed: {}", device.info().name, error_text(error)));
}

}  // namespace

ViewerSamples sample_viewers(const Device& device, const Material& material, const Incidence& light,
                             const SampleRange& range)
try {
    SamplingKernel kernel(device, material, light, "sample");
    kernel.set(3, static_cast<cl_ulong>(range.first));
    kernel.set(4, static_cast<cl_ulong>(range.seed));
    const std::size_t plane = kernel.plane_of(range.count), channels = material.channels();
    const std::vector<float> values = kernel.run(sample_weights + channels, plane);
    const auto field = [&](std::size_t number) { return values.data() + number * plane; };
    ViewerSamples samples;
    for (std::size_t k = 0; k < range.count; ++k)
        samples.viewer.emplace_back(field(sample_x)[k], field(sample_y)[k], field(sample_z)[k]);
    samples.pdf.assign(field(sample_pdf), field(sample_pdf) + range.count);
    for (std::size_t c = 0; c < channels; ++c)
        samples.weight.emplace_back(field(sample_weights + c),
                                    field(sample_weights + c) + range.count);
    return samples;
} catch (const cl::Error& error) {
    fail(device, error);
}

std::vector<float> sampling_density(const Device& device, const Material& material,
                                    const Incidence& light, const std::vector<glm::dvec3>& viewers)
try {
    SamplingKernel kernel(device, material, light, "density");
    const std::size_t plane = kernel.plane_of(viewers.size());
    const glm::dvec3 l = unit_vector(light), mirror(-l.x, -l.y, l.z);
    std::vector<float> offsets(offset_fields * plane);
    for (std::size_t k = 0; k < viewers.size(); ++k) {
        const glm::dvec3 offset = viewers[k] - mirror;
        offsets[offset_x * plane + k] = high_part(offset.x);
        offsets[offset_y * plane + k] = high_part(offset.y);
        offsets[offset_z * plane + k] = high_part(offset.z);
    }
    const cl::Buffer buffer = input_buffer(device.state(), offsets);
    kernel.set(3, buffer);
    std::vector<float> density = kernel.run(1, plane);
    density.resize(viewers.size());
    return density;
} catch (const cl::Error& error) {
    fail(device, error);
}

}  // namespace gonio
