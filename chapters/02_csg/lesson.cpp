// Chapter 2: inside lists, and the boolean operations on them.

#include "core/rayscope.hpp"

#include <fmt/format.h>

using namespace rayscope;

namespace {

/// Where a ray's line is inside of something: t ascending, entering and leaving in turn.
using InsideList = std::vector<Crossing<double>>;

std::string text(const InsideList& list) {
    std::string text;
    for (std::size_t i = 0; i < list.size(); i += 2)
        text += fmt::format("({:.6g}, {:.6g}) ", list[i].t, list[i + 1].t);
    return text.empty() ? "never inside" : text.substr(0, text.size() - 1);
}

/// What one solid answers to a ray. The number says later whose wall a crossing is.
InsideList inside_list(const Solid<double>& solid, std::uint32_t number, const Ray<double>& ray) {
    InsideList list;
    for (const Interval<double>& inside : solid.intervals(ray)) {
        list.push_back({inside.enter, {number, inside.enter_face, false}, true});
        list.push_back({inside.exit, {number, inside.exit_face, false}, false});
    }
    return list;
}

/// Two lists on the stack, and one step of the sweep.
InsideList combined(const InsideList& a, Operation operation, const InsideList& b) {
    SpanStack<double> stack;
    for (const InsideList* list : {&a, &b}) {
        stack.push();
        for (const Crossing<double>& crossing : *list) stack.append(crossing);
    }
    stack.combine(operation);
    return {stack.top_begin(), stack.top_begin() + stack.top_size()};
}

InsideList complement(const InsideList& a) {
    SpanStack<double> stack;
    stack.push();
    for (const Crossing<double>& crossing : a) stack.append(crossing);
    stack.complement();
    return {stack.top_begin(), stack.top_begin() + stack.top_size()};
}

constexpr auto unite = Operation::set_union, intersect = Operation::intersection,
               subtract = Operation::difference;

/// A unit sphere about (x, 0, 0).
Solid<double> sphere_at(double x) { return {Sphere<double>{}, Transform<double>::moving({x, 0, 0})}; }

const Ray<double> along_x{{-4, 0, 0}, {1, 0, 0}};
const InsideList A = inside_list(sphere_at(-0.5), 0, along_x), B = inside_list(sphere_at(0.5), 1, along_x);

void four_objects() {
    fmt::print("Two spheres on one line\n");
    for (const auto& [name, list] : {std::pair("A", A),
                                     {"B", B},
                                     {"A | B", combined(A, unite, B)},
                                     {"A & B", combined(A, intersect, B)},
                                     {"A - B", combined(A, subtract, B)},
                                     {"B - A", combined(B, subtract, A)}})
        fmt::print("  {:<6} {}\n", name, text(list));
    const InsideList rest = combined(A, subtract, B);
    fmt::print("  A - B ends on the surface of {}, its normal {}\n\n", rest[1].surface.solid == 1 ? "B" : "A",
               rest[1].surface.flipped ? "turned" : "as it was");
}

/// Any function of two solids is a union of some of the four parts into which they cut space.
void sixteen_objects() {
    fmt::print("All functions of two solids\n");
    const InsideList neither = complement(combined(A, unite, B)), only_a = combined(A, subtract, B),
                     only_b = combined(B, subtract, A), both = combined(A, intersect, B);
    constexpr const char* names[] = {
        "nothing", "!(A | B)",         "A - B", "!B",     "B - A", "!A",     "(A-B) | (B-A)", "!(A & B)",
        "A & B",   "!((A-B) | (B-A))", "A",     "A | !B", "B",     "B | !A", "A | B",         "everything"};
    int bounded = 0;
    for (unsigned parts = 0; parts < 16; ++parts) {
        InsideList list;
        if (parts & 1U) list = neither;
        if (parts & 2U) list = combined(list, unite, only_a);
        if (parts & 4U) list = combined(list, unite, only_b);
        if (parts & 8U) list = combined(list, unite, both);
        const bool ends = (parts & 1U) == 0;
        bounded += ends ? 1 : 0;
        fmt::print("  {:<17} {:<9} {}\n", names[parts], ends ? "bounded" : "endless", text(list));
    }
    fmt::print("  {} of 16 are bounded\n\n", bounded);
}

/// Every node of an object that a recorded ray evaluates, in the order in which that happens.
void print_nodes(const char* scene, std::string_view name, const Ray<double>& ray) {
    const Trace trace = trace_ray(open(std::string(RAYSCOPE_CHAPTERS "/02_csg/") + scene), ray);
    const TracedRay& first = trace.rays.front();
    for (std::size_t i = 0; i < first.events.size(); ++i) {
        const auto* node = std::get_if<NodeEvaluated>(&first.events[i]);
        if (node == nullptr) continue;
        const TraceObject& object = trace.objects[std::size_t(node->object)];
        if (object.name != name) continue;
        std::string list;
        for (const SpanFound& span : spans_after(first, i))
            list += fmt::format(" ({:.6g}, {:.6g})", span.enter.t, span.exit.t);
        fmt::print("  {:<25}{}\n", object.nodes[std::size_t(node->node)].name,
                   list.empty() ? " never inside" : list);
    }
    fmt::print("\n");
}

/// The same letters from left to right, and two trees.
void order_matters() {
    fmt::print("In order or post order\n");
    const InsideList C = inside_list(sphere_at(1.5), 2, along_x);
    fmt::print("  C             {}\n", text(C));
    fmt::print("  (A | B) & C   {}\n", text(combined(combined(A, unite, B), intersect, C)));
    fmt::print("  A | (B & C)   {}\n\n", text(combined(A, unite, combined(B, intersect, C))));
}

void coincident_faces() {
    fmt::print("Faces in the same place\n");
    const InsideList touching = inside_list(sphere_at(1.5), 2, along_x); // touches A at x = 0.5
    fmt::print("  A - A         {}\n", text(combined(A, subtract, A)));
    fmt::print("  A & A         {}\n", text(combined(A, intersect, A)));
    fmt::print("  A | touching  {}\n", text(combined(A, unite, touching)));
    fmt::print("  A & touching  {}\n\n", text(combined(A, intersect, touching)));
}

} // namespace

int main() {
    four_objects();
    sixteen_objects();
    fmt::print("The tree of ((A & B) - C) - D\n");
    print_nodes("tree.toml", "rest", along_x);
    order_matters();
    fmt::print("The bowl from above, a little beside the middle\n");
    print_nodes("glass_bowl.toml", "bowl", {{0.3, 3, 0}, {0, -1, 0}});
    fmt::print("The pierced cylinder, along the hole A\n");
    print_nodes("cylinder_with_holes.toml", "drilled", {{0, 3, 0.5}, {0, -1, 0}});
    coincident_faces();
}
