#include "tests/architecture/source_text.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <stdexcept>

namespace rayscope::test {
namespace {

/// Index just behind the literal that a quote at `start` begins; a quote between digits (1'000) begins none.
std::size_t literal_end(const std::string& line, std::size_t start) {
    const bool separator =
        line[start] == '\'' && start > 0 && std::isxdigit(static_cast<unsigned char>(line[start - 1])) != 0;
    if (separator) return start + 1;
    std::size_t i = start + 1;
    while (i < line.size() && line[i] != line[start]) i += line[i] == '\\' ? 2 : 1;
    return std::min(i + 1, line.size());
}

bool is_quote(char c) { return c == '"' || c == '\''; }

void blank(std::string& line, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) line[i] = ' ';
}

} // namespace

std::vector<std::filesystem::path> sources_under(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    if (!std::filesystem::is_directory(folder)) return files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.is_regular_file() &&
            (entry.path().extension() == ".hpp" || entry.path().extension() == ".cpp"))
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<std::string> lines_of(const std::filesystem::path& file) {
    std::ifstream stream(file);
    if (!stream) throw std::runtime_error("cannot read " + file.string());
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::vector<std::string> without_comments(std::vector<std::string> lines) {
    bool inside = false;
    for (std::string& line : lines) {
        for (std::size_t i = 0; i < line.size();) {
            if (inside) {
                const std::size_t end = line.find("*/", i);
                inside = end == std::string::npos;
                const std::size_t stop = inside ? line.size() : end + 2;
                blank(line, i, stop);
                i = stop;
            } else if (line.compare(i, 2, "//") == 0) {
                blank(line, i, line.size());
            } else if (line.compare(i, 2, "/*") == 0) {
                inside = true;
                blank(line, i, i + 2);
                i += 2;
            } else {
                i = is_quote(line[i]) ? literal_end(line, i) : i + 1;
            }
        }
    }
    return lines;
}

std::string without_literals(std::string line) {
    for (std::size_t i = 0; i < line.size();) {
        const std::size_t end = is_quote(line[i]) ? literal_end(line, i) : i + 1;
        if (end > i + 1) blank(line, i + 1, end - 1);
        i = end;
    }
    return line;
}

} // namespace rayscope::test
