#include "exercises/grader/sandbox.hpp"

#include "exercises/grader/child.hpp"

#include <unistd.h>

namespace rayscope::exercises {
namespace fs = std::filesystem;
namespace {

constexpr const char* temporary_bytes = "268435456"; // for a compiler's temporary files, in memory

void add(std::vector<std::string>& words, std::initializer_list<std::string> more) {
    words.insert(words.end(), more);
}

std::vector<std::string> own_namespaces() {
    return {"bwrap",
            "--unshare-all",
            "--unshare-user",
            "--uid",
            "65534",
            "--gid",
            "65534",
            "--cap-drop",
            "ALL",
            "--clearenv",
            "--die-with-parent",
            "--new-session"};
}

void add_binds(std::vector<std::string>& words, const std::vector<Bind>& binds) {
    for (const Bind& bind : binds)
        add(words, {bind.writable ? "--bind" : "--ro-bind", bind.outside.string(), bind.inside.string()});
}

void add_system(std::vector<std::string>& words) {
    add(words, {"--ro-bind", "/usr", "/usr", "--dev-bind", "/dev/null", "/dev/null", "--setenv", "PATH",
                "/usr/bin:/bin"});
    for (const char* name : {"/bin", "/lib", "/lib32", "/lib64"}) {
        std::error_code ignored;
        if (fs::is_symlink(name, ignored))
            add(words, {"--symlink", fs::read_symlink(name, ignored).string(), name});
        else if (fs::exists(name, ignored))
            add(words, {"--ro-bind", name, name});
    }
    if (fs::exists("/etc/alternatives")) add(words, {"--ro-bind", "/etc/alternatives", "/etc/alternatives"});
}

void add_command(std::vector<std::string>& words, const std::vector<std::string>& command) {
    words.push_back("--");
    words.insert(words.end(), command.begin(), command.end());
}

} // namespace

std::string why_no_sandbox() {
    try {
        std::vector<std::string> words = own_namespaces();
        add_system(words);
        add_command(words, {"/usr/bin/true"});
        Child probe(words, {}, Child::Errors::with_output);
        const auto ended = probe.finish(1000, std::chrono::seconds(10));
        if (!ended) return "bubblewrap does not answer";
        if (ended->code == 127) return "bubblewrap is not installed (package bubblewrap)";
        if (ended->code != 0) return "this system lets bubblewrap make no sandbox: " + ended->output;
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}

std::vector<std::string> confined(const std::vector<Bind>& binds, const std::vector<std::string>& command) {
    std::vector<std::string> words = own_namespaces();
    add_binds(words, binds);
    add(words, {"--remount-ro", "/", "--as-pid-1"});
    add_command(words, command);
    return words;
}

std::vector<std::string> confined_tools(const std::vector<Bind>& binds, const fs::path& folder,
                                        const std::vector<std::string>& command) {
    std::vector<std::string> words = own_namespaces();
    add_system(words);
    add_binds(words, binds);
    add(words,
        {"--size", temporary_bytes, "--tmpfs", "/tmp", "--remount-ro", "/", "--chdir", folder.string()});
    add_command(words, command);
    return words;
}

} // namespace rayscope::exercises
