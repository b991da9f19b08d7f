// SPDX-License-Identifier: Apache-2.0
// The list of hard spots: highlights from narrow to wide, brushed metal, grazing light, exact
// coincidences, the ends of parameters, and numbers below the normal ones.
#include "verify/hard_spots.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonio {
namespace {

using Settings = std::vector<std::pair<std::string_view, double>>;

Lobe lobe_with(std::string_view name, const Settings& settings)
{
    Lobe lobe = default_lobe(name);
    for (const auto& [parameter, number] : settings) lobe.set(parameter, std::vector{number});
    return lobe;
}

Lobe conductor(double eta, double k)
{
    Lobe lobe = lobe_with("ggx", {{"eta", eta}, {"k", k}});
    lobe.set("fresnel", "conductor");
    return lobe;
}

/// The phase's variance is g where light and viewer are along the normal. Light is of 100 nm, the
/// shortest there is: g to 1.6e8 can be asked for.
Lobe wave(double g, double tau)
{
    constexpr double wavelength = 100, um = wavelength / 1000;
    return lobe_with("beckmann_kirchhoff", {{"wavelength", wavelength},
                                            {"sigma", std::sqrt(g) * um / (4 * std::numbers::pi)},
                                            {"tau", tau}});
}

/// Around the mirror direction of light at several angles, from the peak to where `width` (rad, of
/// the half vector) has been left, or the widest that is above the horizon.
std::vector<DirectionPair> highlight(double width)
{
    width = std::min(width, 0.2);
    std::vector<DirectionPair> pairs;
    for (const double theta : {0.0, 20.0, 45.0, 70.0, 85.0})
        for (const double steps : {0.0, 0.1, 0.5, 1.0, 2.0, 3.0}) {
            const double away = 2 * steps * width * 180 / std::numbers::pi;
            pairs.push_back({theta, 10, std::abs(theta - away), theta < away ? 10.0 : 190.0});
            if (theta > 0) pairs.push_back({theta, 10, theta, 190 + away});
        }
    return pairs;
}

/// Light and viewer as near to the horizon as cos theta = 1e-7, on all sides.
std::vector<DirectionPair> grazing()
{
    std::vector<DirectionPair> pairs;
    for (const double cosine : {1e-2, 1e-4, 1e-6, 1e-7})
        for (const double other : {1.0, 1e-3, 1e-7})
            for (const double azimuth : {0.0, 30.0, 90.0, 179.9, 180.0})
                pairs.push_back({90 - std::asin(cosine) * 180 / std::numbers::pi, 0,
                                 90 - std::asin(other) * 180 / std::numbers::pi, azimuth});
    return pairs;
}

/// Light and viewer so far apart in azimuth (degrees) and equally far from the normal, exactly.
std::vector<DirectionPair> apart(double azimuth)
{
    std::vector<DirectionPair> pairs;
    for (const double theta : {0.0, 1e-5, 10.0, 45.0, 80.0, 89.99})
        pairs.push_back({theta, 33, theta, 33 + azimuth});
    return pairs;
}

/// Light along the normal, exactly, where it has no azimuth; and so the viewer, or not.
std::vector<DirectionPair> normal()
{
    std::vector<DirectionPair> pairs;
    for (const double theta : {0.0, 1e-5, 10.0, 45.0, 80.0})
        for (const double azimuth : {0.0, 33.0, 90.0, 200.0}) {
            pairs.push_back({0, azimuth, theta, 120});
            pairs.push_back({theta, 120, 0, azimuth});
        }
    return pairs;
}

/// Angles below the least normal float32, 1.2e-38.
std::vector<DirectionPair> subnormal()
{
    std::vector<DirectionPair> pairs;
    for (const double theta : {1e-36, 1e-40, 1e-44, 1e-60})
        for (const double other : {0.0, 1e-40, 1e-5})
            for (const double azimuth : {0.0, 60.0, 180.0})
                pairs.push_back({theta, 0, other, azimuth});
    return pairs;
}

std::vector<DirectionPair> everywhere()
{
    std::vector<DirectionPair> pairs = highlight(0.2);
    for (const double theta : {5.0, 50.0, 80.0}) pairs.push_back({theta, 0, 60, 70});
    return pairs;
}

}  // namespace

std::vector<HardSpot> hard_spots()
{
    constexpr double retro = 0, mirror = 180;
    const Lobe narrow = lobe_with("ggx", {{"alpha", 1e-5}});
    const Lobe brushed = lobe_with("ward", {{"alpha_x", 1e-4}, {"alpha_y", 1}});
    const Lobe rough = lobe_with("oren_nayar", {{"sigma", 90}});
    std::vector<HardSpot> spots;
    for (const std::string alpha : {"1e-5", "1e-3", "0.1", "1"}) {
        const double a = std::stod(alpha);
        spots.push_back({"GGX, alpha " + alpha + ", on its peak", lobe_with("ggx", {{"alpha", a}}),
                         highlight(a), textbook::ggx});
        spots.push_back({"Beckmann, alpha " + alpha + ", on its peak",
                         lobe_with("beckmann", {{"alpha", a}}), highlight(a), textbook::beckmann});
    }
    for (const auto& [g, tau] :
         {std::pair<std::string, double>{"1e-8", 1}, {"64", 1}, {"1e3", 1}, {"1e8", 1000}})
        spots.push_back({"wave series, g = " + g, wave(std::stod(g), tau), everywhere(),
                         textbook::beckmann_kirchhoff});
    const std::vector<HardSpot> others{
        {"Ward, alpha 1e-4 by 1", brushed, highlight(1e-4), textbook::ward},
        {"Phong, exponent 1e6", lobe_with("phong", {{"exponent", 1e6}}), highlight(5e-4),
         textbook::phong},
        {"Blinn-Phong, exponent 1e6", lobe_with("blinn_phong", {{"exponent", 1e6}}),
         highlight(1e-3), textbook::blinn_phong},
        {"Ashikhmin-Shirley, exponents 1e6 by 1",
         lobe_with("ashikhmin_shirley", {{"n_u", 1e6}, {"n_v", 1}}), highlight(1e-3),
         textbook::ashikhmin_shirley},
        {"GGX, both grazing to cos 1e-7", lobe_with("ggx", {}), grazing(), textbook::ggx},
        {"Oren-Nayar, sigma 90 deg, both grazing", rough, grazing(), textbook::oren_nayar},
        {"Oren-Nayar, exact retro-reflection", rough, apart(retro), textbook::oren_nayar},
        {"GGX, exact retro-reflection", lobe_with("ggx", {}), apart(retro), textbook::ggx},
        {"GGX, alpha 1e-5, exact mirror", narrow, apart(mirror), textbook::ggx},
        {"Ward, alpha 1e-4 by 1, exact mirror", brushed, apart(mirror), textbook::ward},
        {"GGX, alpha 1e-5, exact normal", narrow, normal(), textbook::ggx},
        {"Oren-Nayar, sigma 90 deg, exact normal", rough, normal(), textbook::oren_nayar},
        {"conductor, eta 1 and k 0: no interface", conductor(1, 0), everywhere(),
         textbook::ggx_conductor},
        {"conductor, eta 1, k 1e-3", conductor(1, 1e-3), everywhere(), textbook::ggx_conductor},
        {"conductor, eta 0.05, k 100", conductor(0.05, 100), everywhere(), textbook::ggx_conductor},
        {"GGX, alpha 1e-5, angles of 1e-40", narrow, subnormal(), textbook::ggx},
    };
    spots.insert(spots.end(), others.begin(), others.end());
    return spots;
}

}  // namespace gonio
