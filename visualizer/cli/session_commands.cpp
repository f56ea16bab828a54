// The commands, as help lists them. Short names are gdb's where gdb has the command.

#include "visualizer/cli/session.hpp"

#include <array>

namespace rayscope::cli {

std::span<const Command> commands() {
    using S = Session;
    static constexpr std::array table{
        Command{"next", "n", "[N]", "the next ray, in the order of spawning; N: so many times", &S::next},
        Command{"back", "rn reverse-next prev", "[N]", "the ray before, in that order", &S::back},
        Command{"step", "s", "[N]", "the next event: of this ray, of one that it spawns, or of its parent",
                &S::step},
        Command{"reverse-step", "rs rstep", "[N]", "the event before", &S::step_back},
        Command{"in", "down", "[N]", "into the next ray that this one spawns", &S::in},
        Command{"reverse-in", "rin", "[N]", "into the ray that it spawned before, at its end", &S::back_into},
        Command{
            "over", "o", "[N]",
            "at a ray's start: its next sibling, or out; within a ray: its next event, past what it spawns",
            &S::over},
        Command{"reverse-over", "ro rover", "[N]", "the same backwards", &S::back_over},
        Command{"out", "fin finish up", "[N]", "to the end of this ray, back in its parent", &S::out},
        Command{"reverse-out", "rout rfin reverse-finish", "[N]", "back to where its parent spawned it",
                &S::back_out},
        Command{"continue", "c", "[N]", "on to the next breakpoint, or to the end", &S::go_on},
        Command{"reverse-continue", "rc", "[N]", "back to the breakpoint before, or to the start",
                &S::go_back},
        Command{"until", "u advance", "CONDITION", "on to the next event where the condition holds",
                &S::until},
        Command{"goto", "g j jump", "N[.E]", "ray N, or its event E; start, end. N alone does the same",
                &S::go_to},
        Command{"undo", "", "[N]", "where you were before the last move", &S::undo},
        Command{"pixel", "px", "X,Y", "another pixel of the same scene", &S::pixel},
        Command{"tree", "t", "", "the recursion, this ray marked", &S::tree},
        Command{"path", "bt where backtrace", "", "the rays from the first one to this one", &S::path},
        Command{"ray", "r", "[N]", "this ray, or ray N, in full", &S::ray},
        Command{"event", "e frame f", "", "this event in full", &S::event},
        Command{"list", "l", "[N]", "the N (10) events around this one, in time", &S::list},
        Command{"spans", "sp", "[T]", "where the ray is inside of what, as bars; T: and what contains that t",
                &S::spans},
        Command{"hit", "", "", "the nearest crossing of this ray", &S::hit},
        Command{"light", "", "", "the local light at its hit, term by term", &S::light},
        Command{"refraction", "ref", "", "both sides of the boundary: angles, speeds, Fresnel's shares",
                &S::refraction},
        Command{"cells", "", "[STAGE]", "where a stage (octree) looks for this ray's hit", &S::cells},
        Command{"why-not", "why y", "NAME | cell N [STAGE]",
                "why this ray did not end on that object, or did not look into that cell", &S::why},
        Command{"colour", "col color", "", "the colour of the whole, and where it comes from", &S::colour},
        Command{"energy", "ledger", "",
                "that light by kind and object, and the weight of what was not followed", &S::energy},
        Command{"print", "p inspect", "EXPRESSION", "its value at this event, such as theta_from - critical",
                &S::print},
        Command{"display", "disp", "[EXPRESSION]", "its value after each move", &S::display},
        Command{"undisplay", "und", "[N]", "no more of that", &S::undisplay},
        Command{"break", "b", "CONDITION", "stop there, as in break tir && depth >= 3, break object lens",
                &S::set_break},
        Command{"tbreak", "tb", "CONDITION", "stop there once", &S::set_break_once},
        Command{"watch", "w wa", "EXPRESSION", "stop where its value becomes another", &S::set_watch},
        Command{"delete", "d", "[N]", "remove breakpoint or watch N ($: the last one), or all", &S::remove},
        Command{"enable", "en", "[N]", "let it stop again", &S::enable},
        Command{"disable", "dis", "[N]", "keep it, but do not stop", &S::disable},
        Command{"info", "i", "breakpoints | display | scene | fields",
                "what there is; fields: the names that conditions know", &S::info},
        Command{"find", "", "CONDITION", "the pixels of the image whose traces have such an event", &S::find},
        Command{"diff", "compare m", "LIST | stage NAME | FILE",
                "where other numbers (float,textbook), another stage or another scene first go another way",
                &S::compare},
        Command{"quiz", "", "", "predict each decision before it is shown", &S::quiz},
        Command{"png", "", "FILE", "draw the trace, this ray in front", &S::png},
        Command{"save", "", "FILE",
                ".json, .html, .webp or .vtm: the trace; any other name: your stops and place, for source",
                &S::save},
        Command{"source", "so", "FILE", "carry out the commands of a file", &S::source},
        Command{"help", "h ?", "[COMMAND]", "this list, or one command", &S::help},
        Command{"quit", "q exit", "", "end (or Ctrl-D)", &S::quit},
    };
    return table;
}

} // namespace rayscope::cli
