#include "visualizer/cli/view_command.hpp"

#include "visualizer/cli/failure.hpp"
#include "visualizer/cli/program_beside.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include <unistd.h>

namespace rayscope::cli {

int view(int count, char** arguments) {
    const std::string program = program_beside("rayscope-window");
    std::vector<char*> words(arguments + 1, arguments + count);
    words.push_back(nullptr);
    execv(program.c_str(), words.data());
    if (errno == ENOENT)
        std::fputs(
            "rayscope: this build has no window: it is built where Qt 5 and VTK are installed (Debian: "
            "qtbase5-dev libvtk9-qt-dev); rayscope step shows the same in the terminal\n",
            stderr);
    else
        std::fprintf(stderr, "rayscope: can't run %s: %s\n", program.c_str(), std::strerror(errno));
    return failed;
}

} // namespace rayscope::cli
