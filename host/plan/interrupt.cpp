// SPDX-License-Identifier: Apache-2.0
// The handler sets a flag; everything else happens where the flag is asked for.
#include "plan/interrupt.hpp"

#include <csignal>

#include "gonio/errors.hpp"

namespace gonio {
namespace {

// A signal handler can reach nothing but what has static storage.
volatile std::sig_atomic_t signalled = 0;

extern "C" void note_signal(int)
{
    signalled = 1;
}

}  // namespace

void catch_interrupts()
{
    struct sigaction action = {};
    action.sa_handler = note_signal;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
    sigemptyset(&action.sa_mask);
    for (const int number : {SIGINT, SIGTERM}) sigaction(number, &action, nullptr);
}

bool interrupted()
{
    return signalled != 0;
}

void throw_if_interrupted()
{
    if (interrupted()) throw Interrupted();
}

}  // namespace gonio
