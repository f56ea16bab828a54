// The program that holds a student's function: one call, its arguments from stdin, its answer to descriptor 3; or, with the
// word serve, one call after the other.

#include "wire.hpp"

void rx_answer(rx::wire::Reader& in, rx::wire::Writer& out);

int main(int count, char** words) {
    if (count > 1 && std::string_view(words[1]) == "serve") return rx::wire::serve(rx_answer);
    return rx::wire::run_and_write(
        [](int, char**, rx::wire::Reader& in, rx::wire::Writer& out) { rx_answer(in, out); }, count, words);
}
