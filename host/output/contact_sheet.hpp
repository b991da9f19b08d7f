// SPDX-License-Identifier: Apache-2.0
// One picture of many materials: for each a lit sphere and its lobe in the plane of incidence.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "gonio/device.hpp"
#include "gonio/material.hpp"

namespace gonio {

struct ContactCard {
    Material material;
    std::string title;     ///< UTF-8; what does not fit in its line is cut with an ellipsis
    std::string subtitle;  ///< up to three lines, broken at spaces and line feeds
};

/// Titled with the material's name. The subtitle has a paragraph for each lobe: its model, the
/// variant, and the numbers that differ from the defaults.
ContactCard make_card(const Material& material);

/// Writes a PNG, two columns of cards or more where there are many. Everything drawn is evaluated
/// on the device. The same cards give the same bytes. Throws RunError, and UsageError for no cards.
void write_contact_sheet(const std::filesystem::path& path, const Device& device,
                         const std::vector<ContactCard>& cards);

}  // namespace gonio
