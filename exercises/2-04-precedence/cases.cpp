#include "cases.hpp"

namespace {

/// A, B, C … of the pattern become other letters, all different.
std::string with_letters(Cases& c, const std::string& pattern) {
    std::vector<char> letters;
    for (char letter = 'A'; letter <= 'Z'; ++letter) letters.push_back(letter);
    c.shuffle(letters);
    std::string result = pattern;
    for (char& symbol : result)
        if (symbol >= 'A' && symbol <= 'Z') symbol = letters[static_cast<std::size_t>(symbol - 'A')];
    return result;
}

std::string random_expression(Cases& c, int operations) {
    if (operations == 0) return {static_cast<char>('A' + c.whole(0, 25))};
    const int kind = c.whole(0, 5);
    if (kind == 0)
        return "!" + random_expression(c, 0) +
               (operations > 1 ? "&" + random_expression(c, operations - 2) : "");
    if (kind == 1) return "!(" + random_expression(c, operations - 1) + ")";
    const int left = c.whole(0, operations - 1);
    const std::string a = random_expression(c, left), b = random_expression(c, operations - 1 - left);
    const char op = "&|-"[c.whole(0, 2)];
    return (left > 1 && kind == 2 ? "(" + a + ")" : a) + op +
           (kind == 3 && operations - 1 - left > 1 ? "(" + b + ")" : b);
}

} // namespace

void cases(Cases& c) {
    const auto add = [&](const char* pattern) { c.add(pattern, with_letters(c, pattern)); };
    c.group("basic");
    for (const char* pattern : {"A&B", "!A", "A|B&C", "A&B|C", "A|B&!C", "!A&B", "(A|B)&C", "A|!B|C"})
        add(pattern);
    c.group("edge");
    for (const char* pattern : {"D-A-B-C", "A-B|C", "A|B|C", "A-(B-C)", "A&(B)"}) add(pattern);
    c.group("hard");
    for (const char* pattern : {"A-B&C", "!(A|B)&C-D-E|F", "!!A-B"}) add(pattern);
    for (int i = 0; i < 4; ++i) c.add("a long one", random_expression(c, 8));
}
