#include "visualizer/window/memory.hpp"

#include <cmath>
#include <fstream>
#include <string>

#include <malloc.h>

namespace rayscope::window {

double resident_memory() {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
        if (word == "VmRSS:") {
            double kilobytes = 0;
            status >> kilobytes;
            return std::round(kilobytes / 1024);
        }
    return 0;
}

void give_back_memory() { malloc_trim(0); }

} // namespace rayscope::window
