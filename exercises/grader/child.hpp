#pragma once
// Another program, started with limits, that this one talks to through pipes.

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace rayscope::exercises {

/// Of a started program and all that it starts; nothing: as this program's own.
struct ChildLimits {
    std::optional<std::uint64_t> cpu_seconds, memory_bytes, file_bytes;
};

class Child {
public:
    enum class Errors {
        with_output, ///< stderr goes where stdout goes
        kept_apart,  ///< it is this program's own
    };

    /// Starts words[0], found on the PATH. Throws std::runtime_error.
    Child(const std::vector<std::string>& words, const ChildLimits& limits, Errors errors);
    /// Kills what still runs.
    ~Child();
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    /// False if the child does not read any more.
    bool write(std::string_view bytes);
    void close_input();
    /// Exactly so many bytes; nothing if the child ended before, or took longer than the time that is left.
    [[nodiscard]] std::optional<std::string> read(std::size_t count, std::chrono::milliseconds at_most);
    /// What it writes until it ends, at most so much of it, and its exit code (128 + signal if one killed it); nothing if
    /// it takes longer.
    struct Ended {
        std::string output;
        int code = 0;
    };
    [[nodiscard]] std::optional<Ended> finish(std::size_t most_output, std::chrono::milliseconds at_most);

private:
    pid_t process_ = -1;
    int input_ = -1, output_ = -1;
};

} // namespace rayscope::exercises
