// The program that holds a student's function: one call, its arguments from stdin, its answer to descriptor 3.

#include "wire.hpp"

void rx_answer(rx::wire::Reader& in, rx::wire::Writer& out);

int main(int count, char** words) {
    return rx::wire::run_and_write(
        [](int, char**, rx::wire::Reader& in, rx::wire::Writer& out) { rx_answer(in, out); }, count, words);
}
