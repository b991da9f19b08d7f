// SPDX-License-Identifier: Apache-2.0
// A line on the terminal: what is being done, the fraction done and the time left.
#pragma once

#include <chrono>
#include <cstdio>
#include <string>

namespace gonio {

/// Silent unless the stream is a terminal. The line is removed when the object ends.
class Progress {
public:
    /// total: the amount of work, in any unit.
    explicit Progress(double total, std::FILE* stream = stderr);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Says what is being done from now on.
    void begin(std::string label);

    /// That much work is done, in the unit of the total.
    void advance(double amount);

private:
    using Clock = std::chrono::steady_clock;

    void show(Clock::time_point now);
    std::string line(Clock::time_point now) const;

    std::FILE* stream_;
    bool terminal_;
    bool colour_;
    double total_;
    double done_ = 0;
    std::string label_;
    Clock::time_point start_;
    Clock::time_point shown_;
};

}  // namespace gonio
