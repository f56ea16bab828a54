#include "visualizer/cli/program_beside.hpp"

namespace rayscope::cli {

std::filesystem::path program_beside(const char* name) {
    std::error_code error;
    return std::filesystem::read_symlink("/proc/self/exe", error).parent_path() / name;
}

} // namespace rayscope::cli
