// SPDX-License-Identifier: Apache-2.0
// Remembers solved slabs, for media that share layers: doubling takes nearly all of a solution's
// time.
#pragma once

#include <cstddef>
#include <deque>

#include "reference/adding_doubling/slab.hpp"

namespace gonio::reference {

/// A SlabSolver. Copies share nothing; it is for one thread.
class SlabMemory {
public:
    Slab operator()(const Layer& layer, const LocalDirections& directions, int mode);

    std::size_t size() const { return solved_.size(); }  ///< slabs that it remembers

private:
    struct Solved {
        Layer layer;
        LocalDirections directions;
        int mode;
        Slab slab;
    };

    std::deque<Solved> solved_;  // the latest in front
};

}  // namespace gonio::reference
