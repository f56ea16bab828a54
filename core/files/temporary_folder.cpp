#include "core/files/temporary_folder.hpp"

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include <stdlib.h>

namespace rayscope {

TemporaryFolder::TemporaryFolder(const std::filesystem::path& pattern) {
    std::string name = pattern.string();
    if (mkdtemp(name.data()) == nullptr)
        throw std::runtime_error("can't make a temporary folder " + pattern.string() + ": " +
                                 std::strerror(errno));
    path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

} // namespace rayscope
