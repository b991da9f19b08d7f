// SPDX-License-Identifier: Apache-2.0
// Chooses bases among the media of wavelengths, and the weights between them.
#include "skin/spectral_bases.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "skin/absorption_classes.hpp"

namespace gonio {
namespace {

constexpr double fine_step = 0.2;  // where relative errors far from the beam count
/// Of the largest value: what the coarsest steps keep interpolation to about half of, in all models
/// of skin. It falls with the cube of the step.
constexpr double coarse_error = 0.02;
constexpr std::size_t rule = 4;  // bases that a medium lies between

double change(double a, double b)
{
    return a > 0 && b > 0 ? std::abs(std::log(b / a)) : std::abs(b - a);
}

/// Of what photons cannot exchange afterwards, the largest of all layers.
double change(const LayeredMedium& a, const LayeredMedium& b)
{
    double most = 0;
    for (std::size_t k = 0; k < a.layers.size(); ++k) {
        const Layer &one = a.layers[k], &other = b.layers[k];
        for (const double each : {change(reduced_scattering(one), reduced_scattering(other)),
                                  change(one.mus, other.mus), change(one.n, other.n)})
            most = std::max(most, each);
    }
    return most;
}

/// How far each medium is along the way from the first.
std::vector<double> places(const std::vector<LayeredMedium>& media)
{
    std::vector<double> all{0};
    for (std::size_t k = 1; k < media.size(); ++k)
        all.push_back(all.back() + change(media[k - 1], media[k]));
    return all;
}

/// Media at about even distances, both ends included.
std::vector<std::size_t> nodes(const std::vector<double>& places, double step)
{
    if (places.back() == 0) return {0};  // absorption is all that changes
    const auto count = std::max(static_cast<double>(rule), std::ceil(places.back() / step) + 1);
    std::vector<std::size_t> chosen;
    if (count >= static_cast<double>(places.size())) {
        chosen.resize(places.size());
        std::iota(chosen.begin(), chosen.end(), std::size_t{0});
        return chosen;
    }
    for (double k = 0; k < count; ++k) {
        const double wanted = places.back() * k / (count - 1);
        std::size_t nearest = 0;
        for (std::size_t i = 1; i < places.size(); ++i)
            if (std::abs(places[i] - wanted) < std::abs(places[nearest] - wanted)) nearest = i;
        if (chosen.empty() || chosen.back() != nearest) chosen.push_back(nearest);
    }
    return chosen;
}

/// Lagrange's weight of node k for a place, by all nodes but one; `without` may be none of them.
double weight_of(std::size_t k, const std::vector<double>& at, double place, std::size_t without)
{
    double product = 1;
    for (std::size_t i = 0; i < at.size(); ++i)
        if (i != k && i != without) product *= (place - at[i]) / (at[k] - at[i]);
    return product;
}

/// The first of the nodes that a place lies in the middle of.
std::size_t first_of_rule(const std::vector<double>& at, double place)
{
    const auto above = static_cast<std::size_t>(std::ranges::upper_bound(at, place) - at.begin());
    const std::size_t last = at.size() - std::min(rule, at.size());
    return std::min(above < rule / 2 ? 0 : above - rule / 2, last);
}

/// Divides a medium among the nodes around it, and among these without the farthest.
void add_shares(std::vector<SpectralBase>& bases, const std::vector<double>& at, std::size_t medium,
                double place)
{
    const std::size_t first = first_of_rule(at, place), count = std::min(rule, at.size());
    const std::vector<double> near(at.begin() + static_cast<std::ptrdiff_t>(first),
                                   at.begin() + static_cast<std::ptrdiff_t>(first + count));
    const bool from_the_left = place - near.front() > near.back() - place;
    const std::size_t farthest = from_the_left ? 0 : std::max<std::size_t>(count - 1, 1);
    for (std::size_t k = 0; k < count; ++k) {
        const double weight = weight_of(k, near, place, count);
        const double coarser = k == farthest ? 0 : weight_of(k, near, place, farthest);
        if (weight != 0) bases[first + k].shares.push_back({medium, weight, coarser});
    }
}

/// The least absorption of each layer, and what the shares have more.
void set_absorption(SpectralBase& base, const std::vector<LayeredMedium>& media)
{
    for (std::size_t layer = 0; layer < base.medium.layers.size(); ++layer) {
        double& least = base.medium.layers[layer].mua;
        least = media[base.shares.front().medium].layers[layer].mua;
        for (const BaseShare& share : base.shares)
            least = std::min(least, media[share.medium].layers[layer].mua);
    }
    for (const BaseShare& share : base.shares) {
        auto& more = base.more_absorption.emplace_back();
        for (std::size_t layer = 0; layer < base.medium.layers.size(); ++layer)
            more.push_back(media[share.medium].layers[layer].mua - base.medium.layers[layer].mua);
    }
}

}  // namespace

BaseSpacing spacing_of(const ProfileRequest& request)
{
    BaseSpacing spacing;
    if (request.max_error)
        spacing.step *= std::cbrt(std::min(1.0, *request.max_error / coarse_error));
    if (!request.ring_error) return spacing;
    return {std::min(spacing.step, fine_step), request.width * static_cast<double>(request.rings)};
}

double reduced_scattering(const Layer& layer)
{
    const auto* phase = std::get_if<HenyeyGreenstein>(&layer.phase);
    return layer.mus * (1 - (phase ? phase->g : 0));
}

std::vector<LayeredMedium> media_of(const Skin& skin, const std::vector<double>& wavelengths)
{
    std::vector<LayeredMedium> media;
    for (const double wavelength : wavelengths) media.push_back(skin.layers_at(wavelength));
    return media;
}

std::vector<SpectralBase> spectral_bases(const std::vector<LayeredMedium>& media,
                                         const BaseSpacing& spacing)
{
    const std::vector<double> place = places(media);
    const std::vector<std::size_t> chosen = nodes(place, spacing.step);
    std::vector<double> at;
    std::vector<SpectralBase> bases;
    for (const std::size_t node : chosen) {
        at.push_back(place[node]);
        bases.push_back({media[node], {}, {}});
    }
    for (std::size_t k = 0; k < media.size(); ++k) add_shares(bases, at, k, place[k]);
    if (spacing.reach > 0) bases = split_by_absorption(bases, media, spacing.reach);
    for (SpectralBase& base : bases) set_absorption(base, media);
    return bases;
}

}  // namespace gonio
