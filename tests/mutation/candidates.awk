# candidates.awk -v seed=S -v limit=N FILE: at most N mutants of a C++ file, each one flipped sign or comparison, as
# "line<TAB>column<TAB>from<TAB>to". Which ones are taken depends on the seed alone.

function note(line, column, from, to) {
    found[++count] = line "\t" column "\t" from "\t" to
    # One step of a linear congruential generator, exact in doubles, spreads neighbours apart.
    key[count] = ((line * 7919 + column * 104729 + seed * 15485863) % 2147483648 * 48271) % 2147483647
}

BEGIN {
    pairs = split(" < , > , <= , >= , == , != , + , - , += , -= , && , || ", from, ",")
    split(" > , < , >= , <= , != , == , - , + , -= , += , || , && ", to, ",")
    signs = split("(-;, -;= -;return -;? -;: -;{-", unary, ";")
}

/^[ \t]*#|template|static_assert|operator/ { next }

{
    code = $0
    sub(/\/\/.*/, "", code)
    for (i = 1; i <= pairs; ++i)
        for (at = 0; (step = index(substr(code, at + 1), from[i])) > 0;) {
            at += step
            note(NR, at, from[i], to[i])
        }
    for (i = 1; i <= signs; ++i)
        for (at = 0; (step = index(substr(code, at + 1), unary[i])) > 0;) {
            at += step
            if (substr(code, at + length(unary[i]), 1) ~ /[A-Za-z_(]/)
                note(NR, at, unary[i], substr(unary[i], 1, length(unary[i]) - 1))
        }
}

END {
    for (taken = 0; taken < limit && taken < count; ++taken) {
        best = 0
        for (i = 1; i <= count; ++i)
            if (!(i in used) && (best == 0 || key[i] < key[best])) best = i
        used[best] = 1
        print found[best]
    }
}
