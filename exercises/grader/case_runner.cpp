#include "exercises/grader/case_runner.hpp"

#include "exercises/runner/time_limits.hpp"

#include <fmt/format.h>

#include <csignal>
#include <cstring>
#include <stdexcept>

namespace rayscope::exercises {
namespace fs = std::filesystem;
namespace {

constexpr std::chrono::seconds patience{60}; // with the runner itself, which has limits of its own

// Exit codes of the harness (harness/wire.cpp).
constexpr int not_yet_written = 77, threw = 78;

std::vector<std::string> runner_command(const Toolchain& toolchain, const fs::path& program,
                                        CaseRunner::Trust trust) {
    const bool own = trust == CaseRunner::Trust::own_code;
    const auto command = [&](const fs::path& runner, const fs::path& what) {
        return std::vector<std::string>{runner.string(), what.string(), own ? "trusted" : "computing"};
    };
    if (toolchain.safety() == Safety::unsafe) return command(toolchain.runner(), program);
    const std::vector<Bind> binds{{toolchain.runner(), "/runner"}, {program, "/program"}};
    if (own) return confined_tools(binds, "/", command("/runner", "/program"));
    return confined(binds, command("/runner", "/program"));
}

void add_number(std::string& to, std::size_t number) {
    const auto small = std::uint32_t(number);
    to.append(reinterpret_cast<const char*>(&small), sizeof small);
}
void add_text(std::string& to, const std::string& text) {
    add_number(to, text.size());
    to += text;
}

Outcome outcome_of(char how, int detail, std::string printed, const std::string& answer) {
    Outcome outcome;
    outcome.detail = detail;
    outcome.printed = std::move(printed);
    if (how == 't') {
        outcome.kind = OutcomeKind::timed_out;
    } else if (how == 'o') {
        outcome.kind = OutcomeKind::too_much;
    } else if (how == 's') {
        outcome.kind = OutcomeKind::crashed;
    } else if (detail == not_yet_written) {
        outcome.kind = OutcomeKind::not_written;
    } else if (detail == threw) {
        outcome.kind = OutcomeKind::threw;
    } else if (detail != 0 || answer.empty()) {
        outcome.kind = OutcomeKind::ended_early;
    } else if (auto value = decoded(answer)) {
        outcome.kind = OutcomeKind::answered;
        outcome.value = std::move(*value);
    }
    return outcome;
}

std::string signal_text(int signal) {
    switch (signal) {
    case SIGSEGV: return "SIGSEGV: it used memory that is not its own, or recursed too deeply";
    case SIGABRT: return "SIGABRT: it aborted";
    case SIGFPE: return "SIGFPE: it divided an integer by 0";
    case SIGILL: return "SIGILL: it ran into what is no instruction";
    case SIGXFSZ: return "SIGXFSZ: it wrote into a file";
    case SIGSYS: return "SIGSYS: it asked the system for what is not allowed";
    default: return fmt::format("signal {}", signal);
    }
}

} // namespace

CaseRunner::CaseRunner(const Toolchain& toolchain, const fs::path& program, Trust trust)
    : runner_(runner_command(toolchain, program, trust), {}, Child::Errors::kept_apart) {}

CaseRunner::Raw CaseRunner::run_raw(const Call& call) {
    std::string request;
    add_number(request, call.words.size());
    for (const std::string& word : call.words) add_text(request, word);
    add_text(request, call.input);
    const auto lost = [] { return std::runtime_error("the runner in the sandbox does not answer"); };
    if (!runner_.write(request)) throw lost();
    const auto bytes = [&](std::size_t count) {
        auto text = runner_.read(count, patience);
        if (!text) throw lost();
        return *text;
    };
    const auto number = [&] {
        std::uint32_t value = 0;
        std::memcpy(&value, bytes(sizeof value).data(), sizeof value);
        return value;
    };
    Raw raw;
    raw.how = bytes(1)[0];
    raw.detail = int(number());
    raw.printed = bytes(number());
    raw.answer = bytes(number());
    if (raw.how == 'f') throw std::runtime_error("the sandbox could not start the program");
    return raw;
}

Outcome CaseRunner::run(const Call& call) {
    Raw raw = run_raw(call);
    return outcome_of(raw.how, raw.detail, std::move(raw.printed), raw.answer);
}

Outcome CaseRunner::run_twice(const Call& call) {
    Raw first = run_raw(call);
    if (first.how == 'e') {
        const Raw second = run_raw(call);
        if (second.how != first.how || second.detail != first.detail || second.answer != first.answer)
            return {OutcomeKind::unsteady, {}, 0, std::move(first.printed)};
    }
    return outcome_of(first.how, first.detail, std::move(first.printed), first.answer);
}

bool same(const Outcome& a, const Outcome& b, const Tolerance& tolerance) {
    if (a.kind != b.kind) return false;
    return a.kind != OutcomeKind::answered || same(a.value, b.value, tolerance);
}

std::string text_of(const Outcome& outcome, int digits) {
    switch (outcome.kind) {
    case OutcomeKind::answered: return text_of(outcome.value, digits);
    case OutcomeKind::not_written: return "not yet written (todo)";
    case OutcomeKind::threw: return "an exception";
    case OutcomeKind::crashed: return "a crash (" + signal_text(outcome.detail) + ")";
    case OutcomeKind::timed_out:
        return fmt::format("no answer within {} s of computing", runner::most_computing.count() / 1000);
    case OutcomeKind::ended_early:
        return fmt::format("no answer: the program ended itself (exit code {})", outcome.detail);
    case OutcomeKind::no_value: return "bytes that are no answer";
    case OutcomeKind::too_much: return "output without end";
    case OutcomeKind::unsteady: return "another answer when it is asked again";
    }
    return "";
}

} // namespace rayscope::exercises
