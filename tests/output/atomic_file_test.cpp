// SPDX-License-Identifier: Apache-2.0
// Whole files or none: full disks, unwritable places, killed runs.
#include "output/atomic_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "gonio/errors.hpp"
#include "gonio/table.hpp"
#include "output/png.hpp"
#include "output/sidecar.hpp"
#include "output/table_fixtures.hpp"

namespace gonio {
namespace {

using test::contents;
using testing::HasSubstr;

/// Files of this process cannot grow beyond a limit: what a full disk looks like.
class FileSizeLimit {
public:
    explicit FileSizeLimit(std::size_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN))
    {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit = {bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit()
    {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

private:
    rlimit before_ = {};
    void (*handler_)(int);
};

/// What a killed run leaves.
void leave_temporary(const std::filesystem::path& path)
{
    const auto child = ::fork();
    if (child == 0) {
        AtomicFile file(path);
        file.write("half");
        ::kill(::getpid(), SIGKILL);
    }
    ::waitpid(child, nullptr, 0);
}

std::size_t files_in(const std::filesystem::path& directory)
{
    const std::filesystem::directory_iterator entries(directory);
    return static_cast<std::size_t>(std::distance(begin(entries), end(entries)));
}

class AtomicFiles : public testing::Test {
protected:
    test::TemporaryDirectory directory;
    std::filesystem::path path = directory / "table";
};

TEST_F(AtomicFiles, AppearWholeAndReplaceTheOld)
{
    test::set_contents(path, "old");
    AtomicFile file(path);
    file.write("ne_");
    file.seek(2);
    file.write("w");
    EXPECT_EQ(contents(path), "old");
    file.commit();
    EXPECT_EQ(contents(path), "new");
    EXPECT_EQ(files_in(directory.path()), 1u);
}

TEST_F(AtomicFiles, SayWhereTheyCannotBe)
{
    for (const auto& place : {directory / "missing/table", directory.path()}) {
        try {
            AtomicFile file(place);
            ADD_FAILURE() << place << " could be created";
        } catch (const RunError& fault) {
            EXPECT_THAT(fault.what(), HasSubstr(place.string()));
        }
    }
}

TEST_F(AtomicFiles, ReportAFullDiskEvenIfItShowsOnlyAtTheEnd)
{
    AtomicFile file(path);
    file.write("buffered");
    const FileSizeLimit full(0);
    try {
        file.commit();
        ADD_FAILURE() << "committed";
    } catch (const RunError& fault) {
        EXPECT_THAT(fault.what(), HasSubstr(path.string() + ": cannot be written: File too large"));
    }
}

TEST_F(AtomicFiles, CannotBeCommittedAfterAFailureThatSomebodySwallowed)
{
    AtomicFile file(path);
    {
        const FileSizeLimit full(0);
        const std::string much(1 << 20, 'x');
        EXPECT_THROW(file.write(much), RunError);
    }
    EXPECT_THROW(file.commit(), RunError);
    EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(AtomicFiles, OfAFullDiskLeaveNothingInAnyFormat)
{
    const auto table = test::filled(test::swept_header());
    for (const auto* format : {"exr", "npy", "csv"}) {
        write_table(path, format, table);
        const auto size = std::filesystem::file_size(path);
        std::filesystem::remove(path);
        std::filesystem::remove(sidecar_path(path));
        for (std::size_t limit = 0; limit < size; limit += 1 + size / 10) {
            const FileSizeLimit full(limit);
            EXPECT_THROW(write_table(path, format, table), RunError) << format << ' ' << limit;
            EXPECT_FALSE(std::filesystem::exists(path)) << format << ' ' << limit;
        }
        std::filesystem::remove(sidecar_path(path));
        EXPECT_EQ(files_in(directory.path()), 0u) << format;
    }
    const FileSizeLimit full(10);
    EXPECT_THROW(write_png(path, 1, 1, std::vector<std::uint8_t>(3)), RunError);
    EXPECT_EQ(files_in(directory.path()), 0u);
}

TEST_F(AtomicFiles, OfKilledRunsAreRemovedAndThoseOfLiveOnesAreNot)
{
    leave_temporary(path);
    leave_temporary(directory / "other");
    test::set_contents(directory / ".notes.partial-draft", "somebody's");
    test::set_contents(directory / "table.partial-1", "somebody's");
    AtomicFile alive(directory / "alive");
    EXPECT_EQ(files_in(directory.path()), 5u);
    EXPECT_EQ(remove_stale_temporaries(directory.path()).size(), 2u);
    EXPECT_EQ(files_in(directory.path()), 3u);
    alive.write("whole");
    alive.commit();
    EXPECT_EQ(contents(directory / "alive"), "whole");
}

TEST_F(AtomicFiles, ReplaceWhatAKilledRunWithTheSameNumberLeft)
{
    const auto temporary = directory / (".table.partial-" + std::to_string(::getpid()));
    test::set_contents(temporary, "half of something longer");
    AtomicFile file(path);
    file.write("whole");
    EXPECT_THROW(AtomicFile second(path), RunError);
    file.commit();
    EXPECT_EQ(contents(path), "whole");
}

}  // namespace
}  // namespace gonio
