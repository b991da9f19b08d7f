// SPDX-License-Identifier: Apache-2.0
// A file that is visible under its name only when it is complete; every format writes through it.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace gonio {

/// Writes `.<name>.partial-<pid>` beside `path` and renames it when all of it is on the disk.
/// The temporary is locked while it is written, so that a later run can tell it from one that a
/// killed run left. Every failure is a RunError with the path and the system's words; after one,
/// commit() fails too, even if the caller (a library's destructor) swallowed it.
class AtomicFile {
public:
    explicit AtomicFile(std::filesystem::path path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    void write(const void* bytes, std::size_t count);
    void write(std::string_view text) { write(text.data(), text.size()); }
    void seek(std::uint64_t offset);
    std::uint64_t position() const { return position_; }

    /// Flushes to the disk and renames: a file of that name is replaced in one step.
    void commit();

    const std::filesystem::path& path() const { return path_; }

private:
    [[noreturn]] void fail(const std::string& what);

    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };

    std::filesystem::path path_;
    std::filesystem::path temporary_;
    std::unique_ptr<std::FILE, Close> file_;
    std::uint64_t position_ = 0;
    std::string failure_;
};

/// The whole of a file in one step.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// A copy of `from`, in one step. Throws RunError.
void copy_complete_file(const std::filesystem::path& from, const std::filesystem::path& to);

/// Makes a folder if need be, and removes what killed runs left there. Throws RunError.
void prepare_directory(const std::filesystem::path& directory);

/// Removes the temporaries in `directory` that no running process holds, and returns their paths.
std::vector<std::filesystem::path> remove_stale_temporaries(const std::filesystem::path& directory);

}  // namespace gonio
