#include "tests/chapters/pages.hpp"

#include "tests/support/temporary_folder.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <sstream>

#include <sys/wait.h>

namespace rayscope::test {

std::vector<std::string> lesson_pages() {
    std::vector<std::string> pages;
    for (const auto& entry : std::filesystem::directory_iterator(chapters_root / "chapters")) {
        std::filesystem::path page = entry.path();
        if (entry.is_directory()) page /= "README.md";
        if (page.extension() == ".md" && std::filesystem::exists(page))
            pages.push_back(page.lexically_relative(chapters_root).generic_string());
    }
    std::sort(pages.begin(), pages.end());
    return pages;
}

std::string page_text(const std::string& page) { return content_of(chapters_root / page); }

std::vector<std::string> lines_of_text(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::filesystem::path built_program(const std::string& name) {
    return std::filesystem::path(RAYSCOPE_PROGRAM).parent_path() / name;
}

Printed printed_by(const std::string& arguments, const std::filesystem::path& folder) {
    const std::string lesson = "lesson ";
    std::string program = RAYSCOPE_PROGRAM, rest = arguments;
    if (arguments.starts_with(lesson)) {
        program = built_program("lesson_" + arguments.substr(lesson.size())).string();
        rest.clear();
    }
    const std::string command =
        "cd '" + folder.string() + "' && '" + program + "' " + rest + " 2>&1 </dev/null";
    FILE* const pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return {-1, "could not run " + command};
    Printed printed;
    std::array<char, 4096> bytes{};
    while (const std::size_t count = std::fread(bytes.data(), 1, bytes.size(), pipe))
        printed.text.append(bytes.data(), count);
    const int status = pclose(pipe);
    printed.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128;
    return printed;
}

} // namespace rayscope::test
