// SPDX-License-Identifier: Apache-2.0
// Texts of scenes around the part that a test is about.
#include "scene/scene_fixtures.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "gonio/errors.hpp"
#include "gonio/scene.hpp"

namespace gonio::test {
namespace {

constexpr const char* right_grid = "kind = \"isotropic\", theta_i = 2, theta_o = 3, delta_phi = 4";
constexpr const char* right_material = "name = \"steel\"\nmodel = \"ward\"";

std::string or_else(const std::string& text, const std::string& otherwise)
{
    return text.empty() ? otherwise : text;
}

/// Removes the @ and returns "scene.toml:line:column: " of what stood behind it.
std::string take_place(std::string& text)
{
    const auto at = text.find('@');
    if (at == std::string::npos) return {};
    text.erase(at, 1);
    const auto before = text.substr(0, at);
    const auto line_begin = before.rfind('\n') + 1;  // npos + 1 is 0
    return fmt::format("scene.toml:{}:{}: ", std::ranges::count(before, '\n') + 1,
                       at - line_begin + 1);
}

}  // namespace

std::string SceneText::text() const
{
    return fmt::format("[output]\n{}\n[[material]]\n{}\n[[table]]\n{}\n", output,
                       or_else(material, right_material),
                       or_else(table, fmt::format("material = \"steel\"\nquantity = \"brdf\"\n"
                                                  "grid = {{ {} }}",
                                                  or_else(grid, right_grid))));
}

std::string refusal(std::string text)
{
    const auto place = take_place(text);
    try {
        parse_scene(text, "scene.toml");
    } catch (const UsageError& fault) {
        const std::string message = fault.what();
        EXPECT_TRUE(message.starts_with(place)) << "at " << place << "not\n   " << message;
        return message.substr(std::min(place.size(), message.size()));
    }
    return {};
}

std::string bad_output(const std::string& lines)
{
    return refusal(SceneText{.output = lines}.text());
}

std::string bad_material(const std::string& lines)
{
    return refusal(SceneText{.material = "name = \"steel\"\n" + lines}.text());
}

std::string bad_parameter(const std::string& lines)
{
    return bad_material("model = \"ward\"\n[material.parameters]\n" + lines);
}

std::string bad_table(const std::string& lines)
{
    return refusal(SceneText{.table = lines}.text());
}

std::string bad_request(const std::string& lines)
{
    return bad_table(fmt::format("material = \"steel\"\nquantity = \"brdf\"\ngrid = {{ {} }}\n{}",
                                 right_grid, lines));
}

std::string bad_grid(const std::string& pairs)
{
    return refusal(SceneText{.grid = pairs}.text());
}

}  // namespace gonio::test
