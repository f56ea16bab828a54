#include "exercises/program/commands.hpp"

#include "exercises/program/failure.hpp"

namespace rayscope::exercises {

int run_command(const Context& context) {
    return std::visit(
        [&](const auto& command) {
            if constexpr (requires { run(context, command); })
                return run(context, command);
            else
                return wrong_usage;
        },
        context.options.command);
}

} // namespace rayscope::exercises
