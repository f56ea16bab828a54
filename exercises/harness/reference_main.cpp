// The program that holds an exercise's cases, its solution and its misconceptions. Its first word says what is asked:
//   cases SEED        the cases of a seed: group, about, call, group, …
//   answer VARIANT    the answer of the solution (0) or of a misconception, from 1, to the call on stdin
//   judge             of a call and an answer: a complaint or nothing
//   show              of a call, the right answer, the one to be drawn, and the student's: a scene and a ray

#include "cases.hpp"

void rx_cases(rx::Cases& cases);
void rx_answer(int variant, rx::wire::Reader& in, rx::wire::Writer& out);
void rx_judge(rx::wire::Reader& in, rx::wire::Writer& out);
void rx_show(rx::wire::Reader& in, rx::wire::Writer& out);

namespace {

void work(int count, char** words, rx::wire::Reader& in, rx::wire::Writer& out) {
    const std::string_view what = count > 1 ? words[1] : "";
    if (what == "cases" && count > 2) {
        rx::Cases cases(std::stoull(words[2]));
        rx_cases(cases);
        cases.write(out);
    } else if (what == "answer" && count > 2) {
        rx_answer(std::stoi(words[2]), in, out);
    } else if (what == "judge") {
        rx_judge(in, out);
    } else if (what == "show") {
        rx_show(in, out);
    } else {
        throw std::runtime_error("expected cases SEED, answer VARIANT, judge or show");
    }
}

} // namespace

int main(int count, char** words) { return rx::wire::run_and_write(work, count, words); }
