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
        if (c == '!') return "(!" + sum() + ")";
        if (c != '(') return {c};
        const std::string inner = sum();
        take();
        return inner;
    }
    std::string product() {
        std::string left = factor();
        while (peek() == '&' || peek() == '-') {
            const char op = take();
            left = "(" + left + op + factor() + ")";
        }
        return left;
    }
    std::string sum() {
        std::string left = product();
        while (peek() == '|') {
            take();
            left = "(" + left + "|" + product() + ")";
        }
        return left;
    }
};

std::string parens(std::string_view e) { return Parser{e}.sum(); }
