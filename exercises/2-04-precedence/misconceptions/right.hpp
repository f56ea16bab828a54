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
        const std::string inner = sum();
        take();
        return inner;
    }
    std::string product() {
        const std::string left = factor();
        if (peek() != '&' && peek() != '-') return left;
        const char op = take();
        return "(" + left + op + product() + ")";
    }
    std::string sum() {
        const std::string left = product();
        if (peek() != '|') return left;
        take();
        return "(" + left + "|" + sum() + ")";
    }
};

std::string parens(std::string_view e) { return Parser{e}.sum(); }
