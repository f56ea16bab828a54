#pragma once
// A folder that a test writes into, gone with all that is in it when the test ends.

#include "core/files/temporary_folder.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

namespace rayscope::test {

class TemporaryFolder : public rayscope::TemporaryFolder {
public:
    TemporaryFolder()
        : rayscope::TemporaryFolder(std::filesystem::temp_directory_path() / "rayscope-test-XXXXXX") {}

    /// Names of what is in it, hidden files too, sorted.
    [[nodiscard]] std::vector<std::string> names() const {
        std::vector<std::string> found;
        for (const auto& entry : std::filesystem::directory_iterator(path()))
            found.push_back(entry.path().filename().string());
        std::sort(found.begin(), found.end());
        return found;
    }
};

[[nodiscard]] inline std::string content_of(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

} // namespace rayscope::test
