#include "tests/chapters/pages.hpp"

#include "tests/support/temporary_folder.hpp"

#include <algorithm>
#include <sstream>

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
    return printed_by_shell("cd '" + folder.string() + "' && '" + program + "' " + rest);
}

} // namespace rayscope::test
