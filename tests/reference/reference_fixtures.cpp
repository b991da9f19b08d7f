// SPDX-License-Identifier: Apache-2.0
// References by name, and directions by angle, for every test that compares with them.
#include "reference/reference_fixtures.hpp"

#include <charconv>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

namespace gonio {

glm::dvec3 direction(double theta, double phi)
{
    const double t = theta * std::numbers::pi / 180, p = phi * std::numbers::pi / 180;
    return {std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), std::cos(t)};
}

glm::dvec3 direction_of_cosine(double cosine, double phi)
{
    const double sine = std::sqrt((1 - cosine) * (1 + cosine));
    return {sine * std::cos(phi), sine * std::sin(phi), cosine};
}

Lobe lobe_of(std::string_view text)
{
    std::istringstream words{std::string(text)};
    std::string word;
    words >> word;
    Lobe lobe = default_lobe(word);
    while (words >> word) {
        const std::size_t equals = word.find('=');
        const std::string name = word.substr(0, equals), value = word.substr(equals + 1);
        double number = 0;
        const auto end = value.data() + value.size();
        if (std::from_chars(value.data(), end, number).ptr == end)
            lobe.set(name, {number});
        else
            lobe.set(name, value);
    }
    return lobe;
}

Brdf reference_of(std::string_view text, Measure measure)
{
    const Reference f = make_reference({"", {lobe_of(text)}}, measure, Parameters::as_given);
    return [f](glm::dvec3 l, glm::dvec3 v) { return f(l, v, 0); };
}

const std::array<Geometry, 4>& golden_geometries()
{
    static const std::array<Geometry, 4> all{{{direction(30, 0), direction(30, 180)},
                                              {direction(45, 0), direction(20, 150)},
                                              {direction(80, 10), direction(85, 200)},
                                              {direction(60, 40), direction(50, 45)}}};
    return all;
}

}  // namespace gonio
