#include "exercises/program/overview.hpp"

#include "core/files/atomic_file.hpp"
#include "exercises/grader/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>

namespace rayscope::exercises {
namespace fs = std::filesystem;
namespace {

Achievement achieved(const Progress& progress, const std::string& id) {
    const auto found = progress.find(id);
    return found == progress.end() ? Achievement{} : found->second;
}

std::string squeezed(const std::string& text) {
    std::string result;
    for (const char c : text)
        if (std::isspace(static_cast<unsigned char>(c)) == 0)
            result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return result;
}

std::optional<double> whole_number(const std::string& text) {
    char* end = nullptr;
    const double number = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0' || !std::isfinite(number)) return std::nullopt;
    return number;
}

} // namespace

const Exercise* next_exercise(const std::vector<Exercise>& catalogue, const Progress& progress) {
    const Exercise* open = nullptr;
    for (const Exercise& exercise : catalogue) {
        if (achieved(progress, exercise.id).passed) continue;
        if (open == nullptr) open = &exercise;
        const bool ready = std::ranges::all_of(
            exercise.prerequisites, [&](const std::string& id) { return achieved(progress, id).passed; });
        if (ready) return &exercise;
    }
    return open;
}

std::string list_text(const std::vector<Exercise>& catalogue, const Progress& progress,
                      const Screen& screen) {
    std::string text;
    int chapter = -1;
    for (const Exercise& exercise : catalogue) {
        if (exercise.chapter != chapter) text += fmt::format("\nChapter {}\n", chapter = exercise.chapter);
        const Achievement mine = achieved(progress, exercise.id);
        const std::string points = fmt::format("{:>6} of {:<3}", points_text(mine.best), exercise.points);
        text += fmt::format("  {} {:<18} {:<34} {}\n", mine.passed ? screen.good("✓") : " ", exercise.id,
                            exercise.title, mine.passed ? screen.good(points) : points);
    }
    return text + "\n" + summary_text(catalogue, progress);
}

std::string summary_text(const std::vector<Exercise>& catalogue, const Progress& progress) {
    double points = 0;
    int total = 0;
    std::size_t passed = 0;
    for (const Exercise& exercise : catalogue) {
        const Achievement mine = achieved(progress, exercise.id);
        points += mine.best;
        total += exercise.points;
        passed += mine.passed ? 1 : 0;
    }
    const std::string sum = fmt::format("{} of {} points", points_text(points), total);
    if (passed == catalogue.size())
        return fmt::format("All {} exercises are right: {}. You are done!\n", passed, sum);
    return fmt::format(
        "{} of {} exercises are right: {}. Hidden cases count; an instructor's have other numbers.\n", passed,
        catalogue.size(), sum);
}

std::string next_text(const std::vector<Exercise>& catalogue, const Workspace& workspace) {
    const Progress progress = workspace.progress();
    const Exercise* const exercise = next_exercise(catalogue, progress);
    if (exercise == nullptr) return summary_text(catalogue, progress);
    return fmt::format("{}\nFile: {}\n", read_code(exercise->task()), workspace.file(*exercise).string());
}

std::string hint_text(const Exercise& exercise, const Workspace& workspace) {
    int shown = 0;
    const int all = int(exercise.hints.size());
    workspace.update([&](Progress& progress) {
        Achievement& mine = progress[exercise.id];
        mine.hints = std::min(mine.hints + 1, all);
        shown = mine.hints;
    });
    std::string text = fmt::format("{}: hint {} of {}\n", exercise.id, shown, all);
    for (int i = 0; i < shown; ++i) text += "\n" + wrapped(exercise.hints[std::size_t(i)], 2);
    return text + (shown == all ? "\nThere are no more hints.\n" : "");
}

std::string reset_text(const Exercise& exercise, const Workspace& workspace) {
    const fs::path file = workspace.file(exercise);
    std::string text;
    if (fs::exists(file)) {
        int number = 1;
        const auto backup = [&] { return fs::path(file.string() + fmt::format(".{}.bak", number)); };
        while (fs::exists(backup())) ++number;
        fs::rename(file, backup());
        text = fmt::format("Your file is now {}.\n", backup().string());
    }
    write_text_file(file, read_code(exercise.stub()));
    return text + fmt::format("{} is the stub again.\n", file.string());
}

bool predicted(const Prediction& prediction, const std::string& answer) {
    const std::string right = squeezed(prediction.answer), given = squeezed(answer);
    const auto expected = whole_number(right), number = whole_number(given);
    if (expected && number) return std::abs(*expected - *number) <= 0.01 * std::abs(*expected);
    return right == given;
}

} // namespace rayscope::exercises
