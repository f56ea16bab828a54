struct Parser {
    std::string_view rest;

    char peek() const { return rest.empty() ? '\0' : rest.front(); }
    char take() {
        const char c = rest.front();
        rest.remove_prefix(1);
        return c;
    }
    std::string factor() {
        const char c = take();
        if (c == '!') return "(!" + factor() + ")";
        if (c != '(') return {c};
        const std::string inner = all();
        take();
        return inner;
    }
    std::string all() {
        std::string left = factor();
        while (peek() == '&' || peek() == '-' || peek() == '|') {
            const char op = take();
            left = "(" + left + op + factor() + ")";
        }
        return left;
    }
};

std::string parens(std::string_view e) { return Parser{e}.all(); }
