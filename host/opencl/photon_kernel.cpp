// SPDX-License-Identifier: Apache-2.0
// The photon kernel with its tallies on a device.
#include "opencl/photon_kernel.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gonio/errors.hpp"
#include "opencl/buffers.hpp"
#include "opencl/program.hpp"

namespace gonio {
namespace {

/// A processor's core has one packet and its own tallies; a graphics card has many lanes that share
/// one set.
PhotonWork divide(const DeviceInfo& info, std::size_t set_bytes, PhotonWork work)
{
    constexpr std::size_t lanes_per_unit = 1024;
    const bool cpu = info.type == "CPU";
    const std::uint64_t most = std::min(info.largest_buffer_bytes, info.global_bytes / 4);
    if (work.items == 0) work.items = std::size_t{info.compute_units} * (cpu ? 1 : lanes_per_unit);
    if (!cpu || work.items * set_bytes > most) work.shared_tallies = true;
    if (set_bytes > most)
        throw UsageError(
            fmt::format("the tallies need {:.3g} MiB, where {} allows {:.3g} MiB; ask for fewer "
                        "bins",
                        static_cast<double>(set_bytes) / 0x1p20, info.name,
                        static_cast<double>(most) / 0x1p20));
    return work;
}

}  // namespace

PhotonKernel::PhotonKernel(const Device& device, PhotonProgram program, std::uint64_t seed,
                           PhotonWork work)
    : device_(device),
      program_(std::move(program)),
      work_(divide(device.info(), program_.sums * sizeof(cl_ulong), work))
{
    Device::State& state = device_.state();
    auto definitions = program_.definitions;
    definitions.push_back(fmt::format("SHARED_TALLIES={}", work_.shared_tallies ? 1 : 0));
    kernel_ = {
        build_program(state, program_.preamble, "photon/transport.cl", definitions, state.width),
        "transport"};
    const std::size_t sets = work_.shared_tallies ? 1 : work_.items;
    tallies_ = {state.context, CL_MEM_READ_WRITE, sets * program_.sums * sizeof(cl_ulong)};
    taken_ = {state.context, CL_MEM_READ_WRITE, sizeof(cl_uint)};
    layers_ = input_buffer(state, program_.layers);
    phases_ = input_buffer(state, program_.phases);
    const KernelSource& source = program_.source;
    cl_uint argument = 0;
    const auto set = [&](auto value) { kernel_.setArg(argument++, value); };
    set(tallies_);
    set(taken_);
    set(layers_);
    set(phases_);
    set(static_cast<cl_uint>(program_.sums));
    argument += 2;  // first and count, of each launch
    set(static_cast<cl_ulong>(seed));
    set(source.sine);
    set(source.cosine);
    set(static_cast<cl_uint>(source.weight));
    set(source.ratio);
    set(source.excess);
    set(source.radius_x);
    set(source.radius_y);
    set(program_.bottom_albedo);
    set(program_.row_bins_per_unit);
    set(program_.radius_bins_per_cm);
    set(program_.depth_bins_per_cm);
    set(static_cast<cl_uint>(program_.wavelengths));
    clear();
}

double PhotonKernel::run(std::uint64_t first, std::uint32_t count)
{
    Device::State& state = device_.state();
    state.queue.enqueueFillBuffer(taken_, cl_uint{0}, 0, sizeof(cl_uint));
    kernel_.setArg(5, static_cast<cl_ulong>(first));
    kernel_.setArg(6, static_cast<cl_uint>(count));
    const bool cpu = state.info.type == "CPU";
    cl::Event event;
    state.queue.enqueueNDRangeKernel(kernel_, cl::NullRange, cl::NDRange(work_.items),
                                     cpu ? cl::NDRange(1) : cl::NullRange, nullptr, &event);
    event.wait();
    return seconds_of(event);
}

std::vector<std::uint64_t> PhotonKernel::take_sums()
{
    const std::size_t sets = work_.shared_tallies ? 1 : work_.items;
    std::vector<std::uint64_t> all(sets * program_.sums);
    device_.state().queue.enqueueReadBuffer(tallies_, CL_TRUE, 0,
                                            all.size() * sizeof(std::uint64_t), all.data());
    clear();
    for (std::size_t k = program_.sums; k < all.size(); ++k) all[k % program_.sums] += all[k];
    all.resize(program_.sums);
    return all;
}

void PhotonKernel::clear()
{
    // Not enqueueFillBuffer(), which Oclgrind 21.10 does not take for an initialisation.
    const std::vector<cl_ulong> zeros(tallies_.getInfo<CL_MEM_SIZE>() / sizeof(cl_ulong));
    device_.state().queue.enqueueWriteBuffer(tallies_, CL_TRUE, 0, zeros.size() * sizeof(cl_ulong),
                                             zeros.data());
}

}  // namespace gonio
