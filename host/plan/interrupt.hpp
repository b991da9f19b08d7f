// SPDX-License-Identifier: Apache-2.0
// Ctrl-C and SIGTERM: the first asks to stop where nothing is lost, the second ends the program.
#pragma once

namespace gonio {

/// From now on SIGINT and SIGTERM set a flag; the second of them has its usual effect.
void catch_interrupts();

bool interrupted();

/// Throws Interrupted after a signal.
void throw_if_interrupted();

}  // namespace gonio
