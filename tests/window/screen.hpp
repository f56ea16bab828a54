#pragma once
// A screen that nobody sees, and the window on it.

#include "tests/cli/program.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace rayscope::test {

/// Xvfb, as long as this lives.
class Screen {
public:
    Screen();
    ~Screen();
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;

    /// False where Xvfb is not installed.
    [[nodiscard]] bool works() const { return number_ >= 0; }
    /// "DISPLAY=:7" and what else a window needs to be the same everywhere.
    [[nodiscard]] std::vector<std::string> environment() const;
    [[nodiscard]] int number() const { return number_; }

private:
    pid_t process_ = -1;
    int number_ = -1;
};

/// Tests of the window, which need a screen.
class Window : public testing::Test {
protected:
    void SetUp() override {
        if (!screen.works()) GTEST_SKIP() << "there is no Xvfb";
    }
    Screen screen;
};

/// What the window reported of each line of a script.
struct Reports {
    Outcome outcome;
    std::vector<nlohmann::json> lines;
    [[nodiscard]] const nlohmann::json& last() const { return lines.back(); }
};

/// Runs `rayscope view SCENE --script …` on the screen.
[[nodiscard]] Reports run_window(const Screen& screen, const std::string& scene, const std::string& script,
                                 const std::vector<std::string>& more = {});

} // namespace rayscope::test
