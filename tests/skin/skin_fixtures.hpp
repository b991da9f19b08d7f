// SPDX-License-Identifier: Apache-2.0
// Skin by the names that the files of tests/data use.
#pragma once

#include <string>

#include "gonio/profile.hpp"
#include "gonio/skin.hpp"

namespace gonio::test {

/// The model and the parameters of "jacques1998_dark", "delgado2011_bil0.25" and so on.
Skin skin_of(const std::string& name);

/// d'Eon & Luebke, GPU Gems 3, chapter 14, 2007: table 14-1.
SumOfGaussians skin_of_gpu_gems();

}  // namespace gonio::test
