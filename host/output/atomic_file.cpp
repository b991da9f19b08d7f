// SPDX-License-Identifier: Apache-2.0
// Temporary name, lock, flush, rename: how a file appears whole or not at all.
#include "output/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <fstream>
#include <system_error>

#include "gonio/errors.hpp"

namespace gonio {
namespace {

constexpr std::string_view marker = ".partial-";

/// A file descriptor that closes itself.
class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor()
    {
        if (number_ >= 0) ::close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    explicit operator bool() const { return number_ >= 0; }
    int number() const { return number_; }

private:
    int number_;
};

std::string system_words(int error)
{
    return std::generic_category().message(error);
}

std::filesystem::path directory_of(const std::filesystem::path& path)
{
    return path.has_parent_path() ? path.parent_path() : ".";
}

bool is_temporary(const std::string& name)
{
    const auto at = name.rfind(marker);
    if (name.front() != '.' || at == std::string::npos) return false;
    const auto pid = name.substr(at + marker.size());
    return !pid.empty() &&
           std::all_of(pid.begin(), pid.end(), [](unsigned char c) { return std::isdigit(c); });
}

/// Whoever writes a temporary holds its lock, which the kernel releases when the process ends.
bool remove_if_stale(const std::filesystem::path& path)
{
    const Descriptor file(::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW));
    return file && ::flock(file.number(), LOCK_EX | LOCK_NB) == 0 && ::unlink(path.c_str()) == 0;
}

/// Between creation and lock another process may have taken the file for a stale one.
bool still_named(int descriptor)
{
    struct stat status = {};
    return ::fstat(descriptor, &status) == 0 && status.st_nlink > 0;
}

/// Returns a stream on a new, locked file, or nullptr with errno set.
std::FILE* create(const std::filesystem::path& path)
{
    for (;;) {
        const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file >= 0) {
            ::flock(file, LOCK_EX);  // a file system without locks only loses the cleaning up
            if (still_named(file)) return ::fdopen(file, "wb");
            ::close(file);
        } else if (errno != EEXIST || !remove_if_stale(path)) {
            return nullptr;
        }
    }
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path path)
    : path_(std::move(path)),
      temporary_(directory_of(path_) /
                 fmt::format(".{}{}{}", path_.filename().string(), marker, ::getpid()))
{
    if (std::filesystem::is_directory(path_)) {
        throw RunError(fmt::format("{}: is a directory, not a file to write", path_.string()));
    }
    file_.reset(create(temporary_));
    if (!file_) fail("cannot be created");
}

AtomicFile::~AtomicFile()
{
    if (file_) ::unlink(temporary_.c_str());
}

void AtomicFile::write(const void* bytes, std::size_t count)
{
    if (std::fwrite(bytes, 1, count, file_.get()) != count) fail("cannot be written");
    position_ += count;
}

void AtomicFile::seek(std::uint64_t offset)
{
    if (offset == position_) return;
    if (::fseeko(file_.get(), static_cast<off_t>(offset), SEEK_SET) != 0) fail("cannot be written");
    position_ = offset;
}

void AtomicFile::commit()
{
    if (!failure_.empty()) throw RunError(failure_);
    if (std::fflush(file_.get()) != 0 || ::fsync(::fileno(file_.get())) != 0) {
        fail("cannot be written");
    }
    // Renamed while it is still locked, or a run that cleans up could take it for a stale one.
    if (::rename(temporary_.c_str(), path_.c_str()) != 0) fail("cannot be put in place");
    file_.reset();
    const Descriptor directory(::open(directory_of(path_).c_str(), O_RDONLY | O_DIRECTORY));
    if (directory) ::fsync(directory.number());
}

void AtomicFile::fail(const std::string& what)
{
    failure_ = fmt::format("{}: {}: {}", path_.string(), what, system_words(errno));
    throw RunError(failure_);
}

std::vector<std::filesystem::path> remove_stale_temporaries(const std::filesystem::path& directory)
{
    std::vector<std::filesystem::path> removed;
    std::error_code unreadable;
    for (const auto& entry : std::filesystem::directory_iterator(directory, unreadable)) {
        if (is_temporary(entry.path().filename().string()) && remove_if_stale(entry.path())) {
            removed.push_back(entry.path());
        }
    }
    return removed;
}

void write_file(const std::filesystem::path& path, std::string_view bytes)
{
    AtomicFile file(path);
    file.write(bytes);
    file.commit();
}

void copy_complete_file(const std::filesystem::path& from, const std::filesystem::path& to)
{
    std::ifstream source(from, std::ios::binary);
    AtomicFile copy(to);
    std::vector<char> piece(std::size_t{1} << 20);
    while (source) {
        source.read(piece.data(), static_cast<std::streamsize>(piece.size()));
        copy.write(piece.data(), static_cast<std::size_t>(source.gcount()));
    }
    if (!source.eof()) throw RunError(fmt::format("{}: cannot be read", from.string()));
    copy.commit();
}

void prepare_directory(const std::filesystem::path& directory)
{
    std::error_code refused;
    std::filesystem::create_directories(directory, refused);
    if (refused)
        throw RunError(
            fmt::format("{}: cannot be made: {}", directory.string(), refused.message()));
    remove_stale_temporaries(directory);
}

}  // namespace gonio
