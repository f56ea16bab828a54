// Grades submissions, one after the other or several at once, and goes on where it was stopped.

#include "core/files/atomic_file.hpp"
#include "core/math/hash.hpp"
#include "core/scene/source_text.hpp"
#include "exercises/grader/parallel.hpp"
#include "exercises/grader/ray_drawing.hpp"
#include "exercises/grader/report_page.hpp"
#include "exercises/grader/submissions.hpp"
#include "exercises/grader/units.hpp"
#include "exercises/program/commands.hpp"
#include "exercises/program/failure.hpp"
#include "exercises/program/feedback.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>

namespace rayscope::exercises {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t most_state = std::size_t(64) << 20U;

/// The exercises that are graded: those that are named, or else all that anybody handed in.
std::vector<const Exercise*> graded(const Context& context, const GradeAll& command,
                                    const Submissions& submissions) {
    std::vector<const Exercise*> chosen;
    for (const std::string& name : command.exercises)
        chosen.push_back(&find_exercise(context.catalogue, name));
    for (const Exercise& exercise : context.catalogue) {
        const auto handed_in = [&](const Submission& submission) {
            return submission.files.contains(exercise.id);
        };
        if (command.exercises.empty() && std::ranges::any_of(submissions.list, handed_in))
            chosen.push_back(&exercise);
    }
    return chosen;
}

/// The code of a file that nobody trusts: what can't be read counts as not compiling, and says why.
struct Code {
    std::string text, problem;
};
Code code_of(const fs::path& file) {
    try {
        return {read_code(file), ""};
    } catch (const InputError& error) {
        return {"", error.message};
    }
}

/// Changes with all that decides a result: the cases and answers, and the student's code.
std::string key_of(const std::vector<Reference>& references, const Submission& submission) {
    Fnv1a hash;
    const auto add = [&](const std::string& text) { hash.add(text.data(), text.size()).add("\0", 1); };
    for (const Reference& reference : references) {
        add(reference.program.filename().string());
        add(std::to_string(reference.seed));
        const auto file = submission.files.find(reference.exercise->id);
        add(file == submission.files.end() ? "" : code_of(file->second).text);
    }
    return fmt::format("{:016x}", hash.value());
}

class Grading {
public:
    Grading(const Toolchain& toolchain, std::vector<Reference> references, fs::path output, bool one)
        : toolchain_(toolchain), references_(std::move(references)), output_(std::move(output)), one_(one) {}

    /// The result that is on disk, if it is of this submission, or a new one, which then is on disk.
    [[nodiscard]] SubmissionMark mark(const Submission& submission) const {
        const fs::path state = output_ / ".state" / (submission.student + ".json");
        const std::string key = key_of(references_, submission);
        if (auto known = known_mark(state, key, submission)) return *known;
        std::vector<ExerciseMark> exercises;
        for (const Reference& reference : references_)
            exercises.push_back(exercise_mark(reference, submission));
        const std::string text =
            dumped({{"key", key}, {"mark", to_json(mark_of(submission.student, std::move(exercises)))}});
        // As it will be read again: what is no UTF-8 is lost in JSON, and reports must not depend on when they are made.
        SubmissionMark result = read_mark(text, submission);
        write_reports(result);
        // Last: what is on record here is complete.
        write_text_file(state, text);
        return result;
    }

private:
    [[nodiscard]] static std::string dumped(const nlohmann::json& document) {
        return document.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
    }

    [[nodiscard]] static SubmissionMark read_mark(const std::string& text, const Submission& submission) {
        SubmissionMark mark = mark_from_json(nlohmann::json::parse(text).at("mark"));
        mark.student = submission.student;
        return mark;
    }

    [[nodiscard]] std::optional<SubmissionMark> known_mark(const fs::path& state, const std::string& key,
                                                           const Submission& submission) const {
        if (!fs::is_regular_file(state)) return std::nullopt;
        try {
            const std::string text = read_file(state, most_state);
            if (nlohmann::json::parse(text).at("key") != key) return std::nullopt;
            return read_mark(text, submission);
        } catch (const nlohmann::json::exception&) {
            return std::nullopt; // not of this program: graded again
        }
    }

    [[nodiscard]] ExerciseMark exercise_mark(const Reference& reference, const Submission& submission) const {
        const auto file = submission.files.find(reference.exercise->id);
        Compiled nothing;
        if (file == submission.files.end())
            return mark_of(reference, grade(toolchain_, reference, nothing), false);
        const Code code = code_of(file->second);
        if (!code.problem.empty()) {
            nothing.problem = code.problem;
            return mark_of(reference, grade(toolchain_, reference, nothing), true);
        }
        const PrivateFolder folder(toolchain_.cache());
        const Compiled compiled =
            toolchain_.compile(answer_unit(*reference.exercise, code.text), folder.path() / "program");
        const Grade result = grade(toolchain_, reference, compiled);
        ExerciseMark mark = mark_of(reference, result, true);
        if (const auto index = told_case(reference, result, false))
            if (const auto runs =
                    shown_runs(toolchain_, reference, *index, result.cases[*index].outcome, compiled.program))
                mark.ray = {runs->shown.scene, runs->parted ? runs->shown.yours : "",
                            text_of(runs->shown.ray), runs->shown.note, drawn_runs(*runs)};
        return mark;
    }

    void write_reports(const SubmissionMark& mark) const {
        const fs::path folder = one_ ? output_ : output_ / "students" / mark.student;
        fs::create_directories(folder);
        for (const ExerciseMark& exercise : mark.exercises)
            if (exercise.ray) {
                fs::create_directories(folder / "rays");
                write_text_file(folder / "rays" / (exercise.id + ".toml"), exercise.ray->scene);
                if (!exercise.ray->yours.empty())
                    write_text_file(folder / "rays" / (exercise.id + ".yours.toml"), exercise.ray->yours);
            }
        write_text_file(folder / "results.json", gradescope_text(mark));
        write_text_file(folder / "report.html", report_page(mark));
    }

    const Toolchain& toolchain_;
    std::vector<Reference> references_;
    fs::path output_;
    bool one_;
};

} // namespace

int run(const Context& context, const GradeAll& command) {
    const Submissions submissions = find_submissions(command.submissions, context.catalogue);
    const auto exercises = graded(context, command, submissions);
    if (exercises.empty()) throw UsageError("nobody handed in a file of an exercise");
    if (fs::exists(command.output) && !fs::is_directory(command.output))
        throw UsageError(fmt::format("-o: expected a folder, found the file {}", command.output.string()));
    if (!context.options.seed)
        std::fputs("rayscope: graded with the cases that students practise with; --seed N makes others\n",
                   stderr);
    const auto toolchain = make_toolchain(context);
    fs::create_directories(command.output / ".state");
    std::vector<Reference> references(exercises.size());
    in_parallel(exercises.size(), command.jobs, [&](std::size_t i) {
        references[i] = make_reference(*toolchain, *exercises[i], context.seed());
    });
    const Grading grading(*toolchain, std::move(references), command.output, submissions.one);

    std::vector<SubmissionMark> marks(submissions.list.size());
    std::mutex guard;
    std::size_t ready = 0;
    in_parallel(marks.size(), command.jobs, [&](std::size_t i) {
        marks[i] = grading.mark(submissions.list[i]);
        const std::lock_guard lock(guard);
        std::fprintf(stderr, "%zu of %zu\t%s\n", ++ready, marks.size(),
                     harmless(submissions.list[i].student).c_str());
    });
    write_text_file(command.output / "junit.xml", junit_text(marks));
    write_text_file(command.output / "class.csv", class_csv(marks));
    write_text_file(command.output / "items.csv", items_csv(marks));
    for (const SubmissionMark& mark : marks)
        std::printf("%s\t%s of %d\n", harmless(mark.student).c_str(), points_text(mark.score).c_str(),
                    mark.points);
    return done;
}

} // namespace rayscope::exercises
