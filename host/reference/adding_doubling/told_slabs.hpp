// SPDX-License-Identifier: Apache-2.0
// Slabs that tell how many of them are solved.
#pragma once

#include <mutex>

#include "reference/adding_doubling/refinement.hpp"
#include "reference/adding_doubling/slab.hpp"

namespace gonio::reference {

/// A solver, for several threads, of a number of slabs that is about `expected`, infinite where
/// nothing is known. Tells their part after each doubling, of one thread after the other.
class ToldSlabs {
public:
    ToldSlabs(double expected, AfterPart after_part);

    Slab operator()(const Layer& layer, const LocalDirections& directions, int mode);

    void tell();

private:
    double expected_, solved_ = 0;
    AfterPart after_part_;
    std::mutex guard_;
};

}  // namespace gonio::reference
