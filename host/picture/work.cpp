// SPDX-License-Identifier: Apache-2.0
// One thread after the other tells what it has done.
#include "picture/work.hpp"

namespace gonio {

void PictureWork::begin(std::string_view doing)
{
    doing_ = doing;
    advance(0);
}

void PictureWork::advance(double amount)
{
    const std::scoped_lock lock(guard_);
    after_each_(doing_, amount);
}

}  // namespace gonio
