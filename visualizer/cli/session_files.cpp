// Commands that read and write files, and the end.

#include "visualizer/cli/failure.hpp"
#include "visualizer/cli/output_check.hpp"
#include "visualizer/cli/picture_process.hpp"
#include "visualizer/cli/script.hpp"
#include "visualizer/cli/session.hpp"
#include "visualizer/cli/trace_file.hpp"

namespace rayscope::cli {
namespace {

void need_file(const char* command, const std::string& file) {
    if (file.empty()) throw UsageError(std::string(command) + ": expected a file");
}

} // namespace

std::string Session::png(const std::string& file) {
    need_file("png", file);
    check_output("png", file, {".png"});
    if (!can_draw()) throw std::runtime_error(std::string("png: ") + how_to_draw());
    draw(Drawing::png, trace(), file, {}, current());
    return "picture: " + harmless(file) + "\n";
}

// What source reads: stops and displays, and the place.
std::string Session::save(const std::string& file) {
    need_file("save", file);
    if (is_trace_file(file)) {
        check_trace_file("save", file);
        write_trace_file(bench_, trace(), file);
        return "trace: " + harmless(file) + "\n";
    }
    const TraceSource& from = trace().source;
    std::string text = "# rayscope step " + harmless(from.scene) + "\n";
    if (!from.by_hand) text += "pixel " + std::to_string(from.x) + "," + std::to_string(from.y) + "\n";
    for (const StopPoint& point : walk_.stops().all()) {
        text += (point.watches ? "watch "
                 : point.once  ? "tbreak "
                               : "break ") +
                point.expression.text() + "\n";
        if (!point.enabled) text += "disable $\n";
    }
    for (const Display& shown : displays_) text += "display " + shown.expression.text() + "\n";
    const Spot spot = cursor().spot();
    text += "goto " + std::to_string(spot.ray) + "." + std::to_string(spot.event) + "\n";
    check_writable(file);
    write_text_file(file, text);
    return "commands: " + harmless(file) + "\n";
}

std::string Session::source(const std::string& file) {
    need_file("source", file);
    constexpr int deepest = 8;
    if (sources_ >= deepest) throw UsageError("source: files call each other more than 8 deep");
    const auto lines = read_script(file);
    ++sources_;
    std::string text;
    try {
        text = run_lines(*this, lines, file);
    } catch (...) {
        --sources_;
        throw;
    }
    --sources_;
    return text;
}

std::string Session::quit(const std::string& /*nothing*/) {
    ended_ = true;
    return "";
}

} // namespace rayscope::cli
