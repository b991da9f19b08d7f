// SPDX-License-Identifier: Apache-2.0
// Runs expressions of the kernels' language over lists of numbers, at any vector width.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace gonio {

/// Expressions of x and y (`real`), built together on the default device: one program takes hardly
/// longer than one expression. include: the kernel file that they need.
class DeviceFunctions {
public:
    DeviceFunctions(const std::string& include, const std::vector<std::string>& expressions,
                    unsigned width);
    ~DeviceFunctions();
    DeviceFunctions(DeviceFunctions&&) noexcept;

    /// The expression for each k, where x and y are x[k] and y[k]. x.size() == y.size(), a multiple
    /// of 16.
    std::vector<float> operator()(std::size_t expression, const std::vector<float>& x,
                                  const std::vector<float>& y);

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The expression for each k, where x and y (`real`) are x[k] and y[k]; include: the kernel file
/// that it needs. Runs on the default device. x.size() == y.size(), a multiple of 16.
std::vector<float> on_device(const std::string& include, const std::string& expression,
                             const std::vector<float>& x, const std::vector<float>& y,
                             unsigned width = 8);

/// Floats from `from` to `to` (> from, of one sign), evenly in their bits: relatively dense
/// everywhere. count: a multiple of 16.
std::vector<float> floats_between(float from, float to, std::size_t count);

/// |got - exact| in units of the last place of a float of that size.
double ulps(float got, double exact);

}  // namespace gonio
