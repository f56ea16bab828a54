#include "tests/exercises/grading.hpp"

#include <cstdlib>

namespace rayscope::test {

const std::vector<exercises::Exercise>& catalogue() {
    static const auto all = exercises::read_catalogue(RAYSCOPE_SOURCE_DIR "/exercises");
    return all;
}

std::vector<std::string> ids() {
    std::vector<std::string> all;
    for (const exercises::Exercise& exercise : catalogue()) all.push_back(exercise.id);
    return all;
}

std::string test_name(std::string id) {
    for (char& c : id)
        if (c == '-') c = '_';
    return id;
}

const exercises::Toolchain& toolchain() {
    static const auto made = [] {
        setenv("RAYSCOPE_EXERCISES_CACHE", std::filesystem::absolute("exercises-cache").c_str(), 0);
        return std::make_unique<exercises::Toolchain>(RAYSCOPE_SOURCE_DIR "/exercises/harness",
                                                      std::filesystem::path(RAYSCOPE_PROGRAM).parent_path() /
                                                          "rayscope-exercise-runner",
                                                      exercises::Safety::sandboxed);
    }();
    return *made;
}

void InSandbox::SetUp() {
    static const std::string why = exercises::why_no_sandbox();
    if (!why.empty()) GTEST_SKIP() << "no sandbox: " << why;
}

} // namespace rayscope::test
