// SPDX-License-Identifier: Apache-2.0
// Draws the line of progress, ten times a second at most.
#include "plan/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

namespace gonio {
namespace {

constexpr auto interval = std::chrono::milliseconds(100);
constexpr int bar_length = 20;

std::string time_text(double seconds)
{
    const auto whole = static_cast<long>(seconds + 0.5);
    if (whole < 60) return fmt::format("{} s", whole);
    if (whole < 3600) return fmt::format("{}:{:02} min", whole / 60, whole % 60);
    return fmt::format("{}:{:02} h", whole / 3600, whole / 60 % 60);
}

}  // namespace

Progress::Progress(double total, std::FILE* stream)
    : stream_(stream),
      terminal_(::isatty(::fileno(stream)) == 1),
      colour_(std::getenv("NO_COLOR") == nullptr),
      total_(total),
      start_(Clock::now())
{
}

Progress::~Progress()
{
    if (!terminal_) return;
    std::fputs("\r\x1b[K", stream_);
    std::fflush(stream_);
}

void Progress::begin(std::string label)
{
    label_ = std::move(label);
    show(Clock::now());
}

void Progress::advance(double amount)
{
    done_ += amount;
    const auto now = Clock::now();
    if (now - shown_ >= interval) show(now);
}

void Progress::show(Clock::time_point now)
{
    if (!terminal_) return;
    fmt::print(stream_, "\r{}\x1b[K", line(now));
    std::fflush(stream_);
    shown_ = now;
}

std::string Progress::line(Clock::time_point now) const
{
    const double fraction = total_ > 0 ? std::min(1.0, done_ / total_) : 1;
    const auto filled = static_cast<std::size_t>(fraction * bar_length);
    const auto bar = fmt::format("{:-<{}}", std::string(filled, '='), bar_length);
    auto text =
        fmt::format("{} {:3.0f} %", colour_ ? "\x1b[32m" + bar + "\x1b[0m" : bar, 100 * fraction);
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    if (done_ > 0)
        text +=
            fmt::format(", {} left", time_text(elapsed * std::max(0.0, total_ - done_) / done_));
    return text + "  " + label_;
}

}  // namespace gonio
