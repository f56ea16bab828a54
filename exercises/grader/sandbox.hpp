#pragma once
// Where code that nobody trusts is compiled and run: bubblewrap gives it namespaces of its own, in which it sees neither
// the network, nor other processes, nor files but those that are named here.

#include <filesystem>
#include <string>
#include <vector>

namespace rayscope::exercises {

enum class Safety {
    sandboxed,
    unsafe, ///< without namespaces: only limits and the filter of system calls; asked for with --unsafe
};

/// Why there can be no sandbox on this machine; empty if there can be.
[[nodiscard]] std::string why_no_sandbox();

/// A file or folder and the name under which it is seen inside.
struct Bind {
    std::filesystem::path outside, inside;
    bool writable = false;
};

/// The command, to be run inside a sandbox that sees only these files.
[[nodiscard]] std::vector<std::string> confined(const std::vector<Bind>& binds,
                                                const std::vector<std::string>& command);

/// The same for programs of the system, like compilers: they see /usr read-only, and a /tmp of their own.
[[nodiscard]] std::vector<std::string> confined_tools(const std::vector<Bind>& binds,
                                                      const std::filesystem::path& folder,
                                                      const std::vector<std::string>& command);

} // namespace rayscope::exercises
