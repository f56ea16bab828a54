#include "visualizer/cli/find_text.hpp"

#include "visualizer/cli/event_text.hpp"
#include "visualizer/cli/failure.hpp"

#include <fmt/format.h>

namespace rayscope::cli {

Expression expression_of(const std::string& command, const std::string& text, const Vocabulary& vocabulary) {
    try {
        return Expression(text, vocabulary);
    } catch (const WrongExpression& error) {
        constexpr std::size_t longest_shown = 70;
        std::string message = command + ": " + error.what();
        if (columns(text) <= longest_shown && !text.empty())
            message += "\n  " + harmless(text) + "\n  " + std::string(error.column - 1, ' ') + "^";
        throw UsageError(message);
    }
}

void need_condition(const std::string& command, const Expression& expression) {
    if (expression.type() != ValueType::condition)
        throw UsageError(command + ": expected a condition, found a value: compare it with something, as in "
                                   "'depth >= 3' or 'object lens'");
}

void need_stage(const std::string& command, const Expression& expression, bool by_stage) {
    if (expression.asks_for_places() && !by_stage)
        throw UsageError(command + ": cells and other places are looked into by a stage: choose one, such as "
                                   "--stage octree");
}

Trace trace_found(const Workbench& bench, const FindOptions& options, int x, int y) {
    const int width = options.render.width, height = options.render.height;
    if (!options.by_stage) return trace_pixel(bench, x, y, width, height);
    return trace_pixel(bench, *make_stages(bench, options.render.stage, width, height), x, y, width, height);
}

std::vector<FoundPixel> found_pixels(const FindResult& result, std::size_t most) {
    std::vector<FoundPixel> pixels;
    for (int y = 0; y < result.events.height; ++y)
        for (int x = 0; x < result.events.width && pixels.size() < most; ++x)
            if (const float events = result.events.at(x, y); events > 0)
                pixels.push_back({x, y, int(events)});
    return pixels;
}

std::string find_text(const Workbench& bench, const Expression& condition, const FindResult& result,
                      const FindOptions& options, std::size_t listed, const StepStyle& style) {
    const std::int64_t all = std::int64_t(result.events.width) * result.events.height;
    Page page(style.paint);
    const std::string cut = result.cut == 0 ? ""
                                            : "; of " + std::to_string(result.cut) +
                                                  " the record was full, where it may hold unseen";
    if (result.pixels == 0) {
        page.line("None of " + std::to_string(all) + " pixels has it" + cut + ".");
        return page.text();
    }
    page.line(style.paint.bold(std::to_string(result.pixels) + " of " + std::to_string(all) + " pixels") +
              fmt::format(" ({:.3g} %)", 100.0 * result.pixels / double(all)) +
              (result.pixels == 1 ? " has it" : " have it") + cut + ".");
    const auto pixels = found_pixels(result, listed);
    const Trace trace = trace_found(bench, options, pixels.front().x, pixels.front().y);
    const auto first = first_occurrence(trace, condition);
    page.item("first", fmt::format("pixel {},{}", pixels.front().x, pixels.front().y));
    std::string text = page.text();
    if (first) text += event_text({trace, first->ray, first->event}, style, true);
    Page list(style.paint);
    std::string line;
    for (const FoundPixel& pixel : pixels)
        line += fmt::format("{}{},{}", line.empty() ? "" : " ", pixel.x, pixel.y) +
                (pixel.events > 1 ? fmt::format("{}×{}", glue, pixel.events) : "");
    if (std::size_t(result.pixels) > pixels.size())
        line += fmt::format(" … and {} more", std::size_t(result.pixels) - pixels.size());
    list.item("pixels", line);
    return text + list.text();
}

} // namespace rayscope::cli
