#include "exercises/grader/parallel.hpp"
#include "exercises/grader/verify.hpp"
#include "exercises/program/commands.hpp"
#include "exercises/program/failure.hpp"

#include <cstdio>

namespace rayscope::exercises {

int run(const Context& context, const Verify& command) {
    std::vector<const Exercise*> chosen;
    for (const std::string& name : command.names) chosen.push_back(&find_exercise(context.catalogue, name));
    if (chosen.empty())
        for (const Exercise& exercise : context.catalogue) chosen.push_back(&exercise);
    std::vector<std::uint64_t> seeds;
    for (int i = 0; i < command.seeds; ++i) seeds.push_back(context.seed() + std::uint64_t(i));
    const auto toolchain = make_toolchain(context);
    std::mutex guard;
    int wrong = 0;
    in_parallel(chosen.size(), command.jobs, [&](std::size_t i) {
        const auto problems = problems_of(*toolchain, *chosen[i], seeds);
        const std::lock_guard lock(guard);
        std::printf("%-4s %s\n", problems.empty() ? "ok" : "BAD", chosen[i]->id.c_str());
        for (const std::string& problem : problems) std::printf("     - %s\n", problem.c_str());
        std::fflush(stdout);
        wrong += problems.empty() ? 0 : 1;
    });
    std::printf("%zu exercise%s, %d seed%s each: %d with problems\n", chosen.size(),
                chosen.size() == 1 ? "" : "s", command.seeds, command.seeds == 1 ? "" : "s", wrong);
    return wrong == 0 ? done : failed;
}

} // namespace rayscope::exercises
