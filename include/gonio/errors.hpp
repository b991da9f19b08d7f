// SPDX-License-Identifier: Apache-2.0
// The few kinds of failure; main.cpp turns each into text and an exit code, nobody else does.
#pragma once

#include <stdexcept>
#include <string>

namespace gonio {

/// A failure at run time: a full disk, an unreadable table, a budget that was not met. Exit code 1.
struct RunError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The user asked for something that cannot be: says where, what is allowed and the nearest name.
/// Exit code 2.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// No such OpenCL device; says which package to install or which devices there are. Exit code 3.
struct NoDevice : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A kernel did not build; carries options, log and the place of the saved source. Exit code 4.
struct KernelBuildError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The device disagrees with the reference; says device, driver, expected and got. Exit code 5.
struct CheckFailed : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Ctrl-C or SIGTERM, after everything that was finished has been kept. Exit code 130.
struct Interrupted : std::runtime_error {
    Interrupted() : std::runtime_error("interrupted") {}
};

}  // namespace gonio
