// SPDX-License-Identifier: Apache-2.0
// Refuses layered media that no light could travel through.
#include "gonio/layers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

#include "gonio/errors.hpp"

namespace gonio {
namespace {

void require(bool allowed, std::string_view where, std::string_view name, double value,
             std::string_view range)
{
    if (!allowed) throw UsageError(fmt::format("{}{} = {} must be {}", where, name, value, range));
}

bool finite_from_zero(double value)
{
    return std::isfinite(value) && value >= 0;
}

void require_index(double n, std::string_view where, std::string_view name)
{
    require(std::isfinite(n) && n > 0, where, name, n, "finite and above 0");
}

void require_fraction(double value, std::string_view where, std::string_view name)
{
    require(value >= 0 && value <= 1, where, name, value, "in [0, 1]");
}

void require_mean_cosine(double g, std::string_view where, std::string_view name)
{
    require(g > -1 && g < 1, where, name, g, "in (-1, 1)");
}

/// Refuses a phase function whose parameters are out of range; `where` begins the message.
struct PhaseCheck {
    std::string_view where;

    void operator()(const HenyeyGreenstein& phase) const
    {
        require_mean_cosine(phase.g, where, "g");
    }
    void operator()(const Isotropic&) const {}
    void operator()(const Rayleigh&) const {}
    void operator()(const TwoTermHenyeyGreenstein& phase) const
    {
        require_mean_cosine(phase.g_1, where, "g_1");
        require_mean_cosine(phase.g_2, where, "g_2");
        require_fraction(phase.weight_1, where, "weight_1");
    }
    void operator()(const TabulatedPhase& table) const
    {
        const auto& [cosine, value] = table;
        if (cosine.size() < 2 || cosine.size() != value.size()) {
            throw UsageError(
                fmt::format("{}a tabulated phase function has {} cosines and {} values; it needs "
                            "as many of both, and at least 2",
                            where, cosine.size(), value.size()));
        }
        require(cosine.front() == -1, where, "the first cosine", cosine.front(), "-1");
        require(cosine.back() == 1, where, "the last cosine", cosine.back(), "1");
        for (std::size_t i = 1; i < cosine.size(); ++i) {
            require(cosine[i] > cosine[i - 1], where, fmt::format("cosine {}", i + 1), cosine[i],
                    "above the one before it");
        }
        for (std::size_t i = 0; i < value.size(); ++i) {
            require(finite_from_zero(value[i]), where,
                    fmt::format("phase function value {}", i + 1), value[i],
                    "finite and at least 0");
        }
        if (*std::max_element(value.begin(), value.end()) <= 0) {
            throw UsageError(
                fmt::format("{}a tabulated phase function must be above 0 somewhere", where));
        }
    }
};

void validate(const Layer& layer, bool last, std::string_view where)
{
    require(finite_from_zero(layer.mua), where, "mua", layer.mua, "finite and at least 0 1/cm");
    require(finite_from_zero(layer.mus), where, "mus", layer.mus, "finite and at least 0 1/cm");
    require_index(layer.n, where, "n");
    require(layer.d > 0, where, "d", layer.d, "above 0 cm");
    std::visit(PhaseCheck{where}, layer.phase);
    if (std::isfinite(layer.d)) return;
    if (!last) throw UsageError(fmt::format("{}only the last layer may be infinite", where));
    if (layer.mua + layer.mus == 0) {
        throw UsageError(
            fmt::format("{}an infinite layer must absorb or scatter: mua + mus = 0", where));
    }
}

}  // namespace

void validate(const LayeredMedium& medium)
{
    require_index(medium.n_above, "", "n_above");
    require_index(medium.n_below, "", "n_below");
    if (medium.layers.empty()) throw UsageError("a layered medium needs at least one layer");
    for (std::size_t i = 0; i < medium.layers.size(); ++i) {
        validate(medium.layers[i], i + 1 == medium.layers.size(), fmt::format("layer {}: ", i + 1));
    }
    require_fraction(medium.bottom_albedo, "", "bottom_albedo");
    if (medium.bottom != Bottom::open && std::isinf(medium.layers.back().d)) {
        throw UsageError(
            "the last layer is infinite, so that no light reaches the bottom; the bottom must be "
            "open");
    }
}

}  // namespace gonio
