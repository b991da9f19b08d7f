// SPDX-License-Identifier: Apache-2.0
// Work that is begun to see how long all of it takes.
#pragma once

#include <filesystem>
#include <random>
#include <string>

#include "stopwatch.hpp"

namespace gonio {

constexpr double trial_seconds = 0.25;

/// work(after_part) calls after_part, from one thread at a time, with the part of it that is done,
/// and ends where that throws. Returns the seconds that all of it takes, as it seems after the
/// first `enough`; work that ends before has been done.
template <class Work>
double seconds_by_trial(const Work& work, double enough = trial_seconds)
{
    struct Enough {};
    const Stopwatch since;
    double begun = 0, begun_part = -1, now = 0, part = 0;
    try {
        work([&](double done) {
            now = since.seconds();
            part = done;
            if (begun_part < 0) {
                begun = now;
                begun_part = done;
            }
            if (now > enough && part > begun_part) throw Enough{};
        });
    } catch (const Enough&) {
        // What comes before the first part is preparation, and is not repeated.
        return now + (1 - part) * (now - begun) / (part - begun_part);
    }
    return since.seconds();
}

/// A folder for tables that nobody keeps.
class ScratchFolder {
public:
    ScratchFolder()
        : path_(std::filesystem::temp_directory_path() /
                ("gonio-" + std::to_string(std::random_device()())))
    {
        std::filesystem::create_directories(path_);
    }
    ~ScratchFolder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

}  // namespace gonio
