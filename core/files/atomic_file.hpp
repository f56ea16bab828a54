#pragma once
// A file that appears complete or not at all.

#include <filesystem>
#include <string_view>

namespace rayscope {

/// Its content is written to `temporary()`, a new file in the same folder, and takes the name `path` on commit: a
/// reader sees the old file or the whole new one. Without a commit the temporary file is removed.
/// Where the file system can, the new file has no name until then, and a program that is killed leaves nothing.
/// A symbolic link stays; the file that it points to is replaced.
class AtomicFile {
public:
    /// Creates the temporary file, empty. Throws std::runtime_error that names `path` and says why it can't.
    explicit AtomicFile(const std::filesystem::path& path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    [[nodiscard]] const std::filesystem::path& temporary() const { return temporary_; }

    /// Call it once the temporary file is written and closed. Throws std::runtime_error.
    void commit();

private:
    std::filesystem::path path_, temporary_;
    int nameless_ = -1; // the open temporary file, if it has no name
};

/// Throws std::runtime_error, which names the file and says what is wrong, if a file `path` can't be written: the
/// folder is missing or closed to writing, or the name is a folder's or a device's. Leaves nothing behind.
void check_writable(const std::filesystem::path& path);

/// A whole file from text at hand, complete or not at all. Throws std::runtime_error that names the file.
void write_text_file(const std::filesystem::path& path, std::string_view text);

} // namespace rayscope
