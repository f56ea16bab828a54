// rayscope accuracy --cases: what each number type gets wrong, and how many digits it loses, on cases whose answers are
// known exactly.

#include "core/rayscope.hpp"
#include "visualizer/cli/accuracy_files.hpp"
#include "visualizer/cli/commands.hpp"
#include "visualizer/cli/failure.hpp"
#include "visualizer/cli/interrupts.hpp"
#include "visualizer/cli/output_check.hpp"
#include "visualizer/cli/page.hpp"
#include "visualizer/cli/progress.hpp"

#include <cstdio>
#include <cstdlib>

namespace rayscope::cli {
namespace fs = std::filesystem;
namespace {

/// The environment variable RAYSCOPE_ORACLE, else the source's.
fs::path shipped_cases() {
    const char* given = std::getenv("RAYSCOPE_ORACLE");
    return given != nullptr && *given != '\0' ? given : RAYSCOPE_CASES;
}

std::vector<FamilyScores> scores(const fs::path& folder) {
    Progress progress("cases");
    ScoreOptions options;
    options.progress = [&](double share) { progress.show(share); };
    options.stop = &stop_asked_for;
    return score_folder(folder, options);
}

} // namespace

int cases(const CasesOptions& options) {
    const fs::path folder = options.folder ? fs::path(*options.folder) : shipped_cases();
    if (case_files(folder).empty())
        throw UsageError("--cases: expected a folder with case files (*.jsonl), found none in '" +
                         folder.string() + "'");
    if (options.output) prepare_folder(*options.output, "cases.json");
    catch_interrupts();
    std::vector<FamilyScores> families = scores(folder);
    if (stop_asked_for) {
        std::fputs("rayscope: stopped\n", stderr);
        return interrupted;
    }
    for (FamilyScores& row : families) row.family = harmless(row.family); // a file name may hold anything
    std::fputs(scores_table(families).c_str(), stdout);
    if (options.output) {
        write_text_file(fs::path(*options.output) / "cases.md", scores_markdown(families));
        write_text_file(fs::path(*options.output) / "cases.json", scores_json(families));
    }
    return done;
}

} // namespace rayscope::cli
