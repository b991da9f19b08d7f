// SPDX-License-Identifier: Apache-2.0
// The line of progress on a terminal, and its silence elsewhere.
#include "plan/progress.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <stdlib.h>
#include <unistd.h>

#include <array>
#include <memory>

namespace gonio {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A terminal, and what was written to it.
class Terminal {
public:
    Terminal()
    {
        int slave = -1;
        if (::openpty(&master_, &slave, nullptr, nullptr, nullptr) != 0)
            throw std::runtime_error("no terminal");
        stream_.reset(::fdopen(slave, "w"));
    }
    ~Terminal() { ::close(master_); }
    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;

    std::FILE* stream() { return stream_.get(); }

    /// Until nothing has come for a while: the system hands bytes over in parts.
    std::string written()
    {
        std::string all;
        pollfd ready{master_, POLLIN, 0};
        while (::poll(&ready, 1, 200) > 0) {
            std::array<char, 4096> bytes = {};
            const auto count = ::read(master_, bytes.data(), bytes.size());
            all.append(bytes.data(), static_cast<std::size_t>(count));
        }
        return all;
    }

private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };

    int master_ = -1;
    std::unique_ptr<std::FILE, Close> stream_;
};

TEST(Progress, ShowsFractionTimeLeftAndLabel)
{
    Terminal terminal;
    {
        Progress progress(200, terminal.stream());
        progress.advance(50);
        progress.begin("steel");
        const auto line = terminal.written();
        EXPECT_THAT(line, HasSubstr("=====---------------"));
        EXPECT_THAT(line, HasSubstr(" 25 %, 0 s left  steel"));
        EXPECT_EQ(line.find('\n'), std::string::npos);
    }
    EXPECT_THAT(terminal.written(), testing::EndsWith("\r\x1b[K"));
}

TEST(Progress, DoesNotDrawAllTheTime)
{
    Terminal terminal;
    Progress progress(1e6, terminal.stream());
    progress.begin("steel");
    terminal.written();
    for (int k = 0; k < 1000; ++k) progress.advance(1);
    progress.begin("copper");
    const auto text = terminal.written();
    EXPECT_LE(std::count(text.begin(), text.end(), '\r'), 3);
}

TEST(Progress, RespectsNoColor)
{
    const auto line_with = [](const char* no_color) {
        Terminal terminal;
        no_color ? ::setenv("NO_COLOR", no_color, 1) : ::unsetenv("NO_COLOR");
        Progress progress(2, terminal.stream());
        progress.begin("steel");
        return terminal.written();
    };
    EXPECT_THAT(line_with(nullptr), HasSubstr("\x1b[32m"));
    EXPECT_THAT(line_with("1"), Not(HasSubstr("\x1b[32m")));
    ::unsetenv("NO_COLOR");
}

TEST(Progress, IsSilentInAPipe)
{
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::tmpfile(), std::fclose);
    {
        Progress progress(2, file.get());
        progress.begin("steel");
        progress.advance(2);
    }
    EXPECT_EQ(std::ftell(file.get()), 0);
}

}  // namespace
}  // namespace gonio
