// SPDX-License-Identifier: Apache-2.0
// Skin by the names that the files of tests/data use.
#pragma once

#include <string>

#include "gonio/skin.hpp"

namespace gonio::test {

/// The model and the parameters of "jacques1998_dark", "delgado2011_bil0.25" and so on.
Skin skin_of(const std::string& name);

}  // namespace gonio::test
