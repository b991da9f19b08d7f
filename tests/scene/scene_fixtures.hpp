// SPDX-License-Identifier: Apache-2.0
// Texts of scenes around the part that a test is about.
#pragma once

#include <string>

namespace gonio::test {

/// A scene whose only table is of a Ward material: `output`, `material` and `table` are lines of
/// these sections, and `grid` are pairs of the table's grid. Empty ones are replaced by right ones.
struct SceneText {
    std::string output = {};
    std::string material = {};
    std::string table = {};
    std::string grid = {};

    std::string text() const;
};

/// The message that parse_scene refuses this text with; empty if it does not. In `text` an @ is
/// where the message must point; it is removed, and the message loses that place.
std::string refusal(std::string text);

/// refusal() of a scene with these lines in [output], in its [[material]] beside the name, in the
/// parameters of a Ward material, as the whole [[table]], in it beside what it needs, and with
/// these pairs as its grid.
std::string bad_output(const std::string& lines);
std::string bad_material(const std::string& lines);
std::string bad_parameter(const std::string& lines);
std::string bad_table(const std::string& lines);
std::string bad_request(const std::string& lines);
std::string bad_grid(const std::string& pairs);

}  // namespace gonio::test
