#pragma once
// A folder of one's own, gone with all that is in it when it is not needed any more.

#include <filesystem>

namespace rayscope {

class TemporaryFolder {
public:
    /// @param pattern where it is to be, and its name: the last six letters, XXXXXX, become others, so that it is new
    /// Throws std::runtime_error that says why it can't be made.
    explicit TemporaryFolder(const std::filesystem::path& pattern);
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

} // namespace rayscope
