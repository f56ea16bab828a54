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

namespace {

/// Its letters, each once.
std::string letters_of(const std::string& expression) {
    std::string letters;
    for (const char symbol : expression)
        if (symbol >= 'A' && symbol <= 'Z' && letters.find(symbol) == std::string::npos) letters += symbol;
    return letters;
}

/// A solid for each letter: the ray comes through all that can be inside and outside together, in Gray's order, in which
/// one letter changes at a time.
std::string slabs(const std::string& letters, const Ray& r) {
    std::string text;
    for (std::size_t i = 0; i < letters.size(); ++i) {
        Spans spans;
        for (unsigned cell = 0; cell < 1U << letters.size(); ++cell) {
            if (((cell ^ (cell >> 1U)) >> i & 1U) == 0) continue;
            const double begin = 1 + cell;
            if (!spans.empty() && spans.back().b == begin)
                spans.back().b = begin + 1;
            else
                spans.push_back({begin, begin + 1});
        }
        const std::string name(1, letters[i]);
        std::string parts;
        for (std::size_t k = 1; k <= spans.size(); ++k)
            parts += (k == 1 ? "" : " | ") + name + std::to_string(k);
        text += solids(name, r, spans) + "\n[compounds." + name + "]\nis = \"" + parts + "\"\n";
    }
    return text;
}

} // namespace

/// The solid that the answer means. An answer that is no expression of these letters shows nothing.
Shown show(const std::string& e, const std::string&, const std::string& answer) {
    const Ray r{{0, 0, 0}, {0, 0, -1}};
    const std::string letters = letters_of(e);
    if (answer.size() > 8 * e.size() || answer.find_first_not_of(letters + "!&|-()") != std::string::npos)
        throw std::runtime_error("no expression of these letters");
    return {scene(slabs(letters, r) + "\n[compounds.answer]\nis = \"" + answer + "\"\nmaterial = \"clear\"\n",
                  {12, 6, 2}),
            r,
            "The case has no ray. This one comes through the letters' solids in every combination; the solid "
            "'answer' is what the text means."};
}
