// SPDX-License-Identifier: Apache-2.0
// A device of width 8 that the tests of a suite share.
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "gonio/device.hpp"

namespace gonio::test {

/// Programs stay built from test to test; closed while OpenCL is still there.
class SharedDevice : public testing::Test {
protected:
    static void SetUpTestSuite() { device() = std::make_unique<Device>("", 8); }
    static void TearDownTestSuite() { device().reset(); }

    static std::unique_ptr<Device>& device()
    {
        static std::unique_ptr<Device> opened;
        return opened;
    }
};

}  // namespace gonio::test
