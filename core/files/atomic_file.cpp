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

/// A new, empty file beside `target`, with the permissions that the user's files have.
fs::path create_beside(const fs::path& target, const fs::path& asked_for) {
    static std::atomic<unsigned> counter{0};
    for (int attempt = 0; attempt < 100; ++attempt) {
        // The name of the target is left out: it may be as long as names can be.
        const fs::path name =
            target.parent_path() / fmt::format(".rayscope-{}-{}.part", getpid(), counter.fetch_add(1));
        const int file = ::open(name.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
        if (file >= 0) {
            ::close(file);
            return name;
        }
        if (errno != EEXIST) fail(asked_for, reason(errno));
    }
    fail(asked_for, "its folder is full of unfinished files (.rayscope-*.part)");
}

} // namespace

AtomicFile::AtomicFile(const fs::path& path)
    : path_(target_of(path)), temporary_(create_beside(path_, path)) {}

AtomicFile::~AtomicFile() {
    std::error_code ignored;
    if (!temporary_.empty()) fs::remove(temporary_, ignored);
}

void AtomicFile::commit() {
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
