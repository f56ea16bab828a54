#include "core/files/atomic_file.hpp"

#include <fmt/format.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include <fcntl.h>
#include <unistd.h>

namespace rayscope {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void fail(const fs::path& path, const std::string& why) {
    throw std::runtime_error(fmt::format("can't write {}: {}", path.string(), why));
}

std::string reason(int error) {
    // The C library's words for these two leave open which of the two names is meant.
    if (error == EACCES || error == EROFS) return "no permission to write in its folder";
    if (error == ENOENT) return "its folder does not exist";
    return std::strerror(error);
}

/// The file that is to be replaced: the end of a chain of links.
fs::path target_of(const fs::path& path) {
    std::error_code error;
    fs::path target = path;
    for (int links = 0; links < 40 && fs::is_symlink(target, error); ++links) {
        const fs::path next = fs::read_symlink(target, error);
        if (error) break;
        target = target.parent_path() / next;
    }
    const fs::file_status status = fs::status(target, error);
    if (path.empty() || !path.has_filename()) fail(path, "a file name was expected");
    if (fs::is_directory(status)) fail(path, "it is a folder");
    if (fs::exists(status) && !fs::is_regular_file(status)) fail(path, "it is not a regular file");
    // A rename would replace a file that is closed to writing.
    if (fs::exists(status) && access(target.c_str(), W_OK) != 0) fail(path, "no permission to change it");
    return target;
}

/// A file name beside `target` that does not exist. Without the target's own name: that may be as long as names can be.
fs::path fresh_name(const fs::path& target) {
    static std::atomic<unsigned> counter{0};
    return target.parent_path() / fmt::format(".rayscope-{}-{}.part", getpid(), counter.fetch_add(1));
}

constexpr int attempts = 100;

/// A new, empty file beside `target`, with the permissions that the user's files have.
fs::path create_beside(const fs::path& target, const fs::path& asked_for) {
    for (int attempt = 0; attempt < attempts; ++attempt) {
        const fs::path name = fresh_name(target);
        const int file = ::open(name.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
        if (file >= 0) {
            ::close(file);
            return name;
        }
        if (errno != EEXIST) fail(asked_for, reason(errno));
    }
    fail(asked_for, "its folder is full of unfinished files (.rayscope-*.part)");
}

/// The same without a name, as a descriptor; −1 where the file system has no such files.
int create_nameless(const fs::path& target) {
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    return ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
}

fs::path path_of(int descriptor) { return fmt::format("/proc/self/fd/{}", descriptor); }

} // namespace

AtomicFile::AtomicFile(const fs::path& path) : path_(target_of(path)), nameless_(create_nameless(path_)) {
    if (nameless_ >= 0 && access(path_of(nameless_).c_str(), W_OK) != 0) { // no /proc
        ::close(nameless_);
        nameless_ = -1;
    }
    temporary_ = nameless_ >= 0 ? path_of(nameless_) : create_beside(path_, path);
}

AtomicFile::~AtomicFile() {
    std::error_code ignored;
    if (nameless_ >= 0)
        ::close(nameless_);
    else if (!temporary_.empty())
        fs::remove(temporary_, ignored);
}

void AtomicFile::commit() {
    if (nameless_ >= 0) { // a name first, since a link can't replace what is there
        fs::path name = fresh_name(path_);
        int attempt = 0;
        while (::linkat(AT_FDCWD, temporary_.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) != 0) {
            if (errno != EEXIST || ++attempt == attempts) fail(path_, std::strerror(errno));
            name = fresh_name(path_);
        }
        ::close(nameless_);
        nameless_ = -1;
        temporary_ = name;
    }
    std::error_code error;
    fs::rename(temporary_, path_, error);
    if (error) fail(path_, error.message());
    temporary_.clear();
}

void check_writable(const fs::path& path) {
    const fs::path target = target_of(path);
    if (target.filename().string().size() > 255) fail(path, "the name is longer than 255 bytes");
    const AtomicFile probe(path);
}

void write_text_file(const fs::path& path, std::string_view text) {
    AtomicFile file(path);
    std::ofstream out(file.temporary(), std::ios::binary);
    out.write(text.data(), std::streamsize(text.size()));
    out.close();
    if (!out) fail(path, std::strerror(errno));
    file.commit();
}

} // namespace rayscope
