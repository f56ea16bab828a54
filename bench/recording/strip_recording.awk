# Prints a source file without its statements `if constexpr (Recorder::enabled) …`: what the code would be if nothing
# could be recorded.
{
    line = $0
    if (!skipping && line ~ /^ *if constexpr \(Recorder::enabled\)/) {
        skipping = 1; depth = 0; braces = 0
        sub(/^ *if constexpr \(Recorder::enabled\)/, "", line)
    }
    if (!skipping) { print; next }
    for (i = 1; i <= length(line); ++i) {
        c = substr(line, i, 1)
        if (c == "{" && depth == 0) braces = 1
        if (c ~ /[({[]/) ++depth
        if (c ~ /[)}\]]/) --depth
        if (depth == 0 && ((braces && c == "}") || (!braces && c == ";"))) { skipping = 0; break }
    }
}
