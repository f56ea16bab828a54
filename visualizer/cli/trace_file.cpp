#include "visualizer/cli/trace_file.hpp"

#include "visualizer/cli/output_check.hpp"
#include "visualizer/cli/picture_process.hpp"
#include "visualizer/page/page.hpp"

#include <algorithm>
#include <array>

namespace rayscope::cli {
namespace {

constexpr std::array<std::string_view, 4> extensions{".json", ".html", ".webp", ".vtm"};

std::string extension_of(const std::string& file) { return std::filesystem::path(file).extension().string(); }
bool is_drawn(const std::string& extension) { return extension == ".webp" || extension == ".vtm"; }

} // namespace

bool is_trace_file(const std::string& file) {
    return std::ranges::find(extensions, extension_of(file)) != extensions.end();
}

void check_trace_file(const std::string& option, const std::string& file) {
    check_output(option, file, {extensions.begin(), extensions.end()});
    if (is_drawn(extension_of(file)) && !can_draw()) throw std::runtime_error(option + ": " + how_to_draw());
}

void write_trace_file(const Workbench& bench, const Trace& trace, const std::string& file) {
    const std::string extension = extension_of(file);
    if (extension == ".json")
        write_trace(trace, file);
    else if (extension == ".html")
        page::write_page(bench, trace, file);
    else
        draw(extension == ".webp" ? Drawing::webp : Drawing::vtm, trace, file);
}

} // namespace rayscope::cli
