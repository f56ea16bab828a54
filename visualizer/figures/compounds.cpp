// Compound objects: the tree, the bowl, the drilled cylinder.

#include "visualizer/figures/figures.hpp"
#include "visualizer/figures/lanes.hpp"
#include "visualizer/figures/solid.hpp"

#include <map>

namespace rayscope::figures {
namespace {

const char* sign_of(Operation operation) {
    switch (operation) {
    case Operation::set_union: return "∪";
    case Operation::intersection: return "∩";
    case Operation::difference: return "−";
    case Operation::complement: return "¬";
    case Operation::leaf: break;
    }
    return "";
}

/// A scene whose generics have each a material of a plain colour.
Scene coloured(const Scene& scene, const std::vector<std::pair<std::string, Rgb>>& colours) {
    Scene changed = scene;
    for (const auto& [name, rgb] : colours) {
        SceneMaterial material;
        material.ambient = Colour{0};
        material.diffuse = Colour{std::pow(rgb.red / 255.0, 2.2), std::pow(rgb.green / 255.0, 2.2),
                                  std::pow(rgb.blue / 255.0, 2.2)};
        changed.materials.push_back(material);
        for (SceneGeneric& generic : changed.generics)
            if (generic.name == name) generic.material = changed.materials.size() - 1;
    }
    return changed;
}

/// Without what stands around: only the compounds.
Workbench compounds_of(Scene scene) {
    std::erase_if(scene.drawn, [](const SceneObject& object) { return !object.is_compound; });
    return make_workbench(std::move(scene));
}

} // namespace

Svg expression_tree(const Subject& subject) {
    Svg svg(1000, 700);
    const Trace trace = trace_ray(subject.bench, {{-4, 0, 0}, {1, 0, 0}});
    const TraceObject& object = trace.objects.at(0);
    // Leaves from left to right; a node stands over the middle of its operands, each operation a row higher.
    std::map<Id, Pixel> places;
    double next = 110;
    for (std::size_t i = 0; i < object.nodes.size(); ++i)
        if (object.nodes[i].operation == Operation::leaf) {
            places[Id(i)] = {next, 0};
            next += 240;
        }
    double row = 3;
    for (std::size_t i = 0; i < object.nodes.size(); ++i) {
        const TraceNode& node = object.nodes[i];
        if (node.operation == Operation::leaf) continue;
        row -= 1;
        places[Id(i)] = {(places[node.left].x + places[node.right].x) / 2, 60 + 170 * row};
        for (const Id child : {node.left, node.right})
            if (object.nodes[std::size_t(child)].operation == Operation::leaf)
                places[child].y = 60 + 170 * (row + 1);
    }
    for (std::size_t i = 0; i < object.nodes.size(); ++i)
        for (const Id child : {object.nodes[i].left, object.nodes[i].right})
            if (child != none) svg.line(places[Id(i)], places[child], {grey, 2.5});
    for (std::size_t i = 0; i < object.nodes.size(); ++i) {
        const TraceNode& node = object.nodes[i];
        const Pixel at = places[Id(i)];
        const bool leaf = node.operation == Operation::leaf, root = i + 1 == object.nodes.size();
        const Rgb colour = leaf ? sky_blue : (root ? green : orange);
        svg.dot(at, 30, colour);
        svg.circle(at, 30, {black, 2.5});
        svg.text(at, leaf ? node.name : sign_of(node.operation), {28, black, true});
        // The list itself, as a bar and in numbers, below the node.
        const List list = list_of(trace, 0, root ? object.name : node.name);
        const Line line{at.x - 5 * 15, 15, 2, 8, 44, 0};
        const double y = at.y + 52;
        std::string numbers;
        for (const auto& [enter, exit] : list)
            numbers +=
                (numbers.empty() ? "" : "  ") + std::string("(") + digits(enter) + ", " + digits(exit) + ")";
        svg.rectangle({line(1.4), y - 18, 15 * 7.2, 58}, {white, 0.9});
        svg.line({line(2), y}, {line(8), y}, {pale, 4});
        for (const auto& [enter, exit] : list)
            svg.rectangle({line(enter), y - 7, 15 * (exit - enter), 14}, {colour, 1});
        svg.text({at.x, y + 26}, numbers.empty() ? "empty" : numbers, {19, black});
    }
    svg.text({985, 60}, "root: the result", {20, black, true, Anchor::end});
    svg.text({985, 90}, "numbers: t at which the ray", {18, grey, false, Anchor::end});
    svg.text({985, 114}, "enters and leaves", {18, grey, false, Anchor::end});
    return svg;
}

Svg bowl_cut(const Subject& subject) {
    Svg svg(1000, 470);
    const Scene scene =
        coloured(subject.bench.scene, {{"outer", sky_blue}, {"inner", orange}, {"mouth", purple}});
    const Stand stand{{0.42, 0.42, 1}, {0, 1, 0}, {0, 0.18, 0}, 1.75, 0.98, false, 1.5, {}};
    const Solid parts(svg, {0, 30, 330, 360}, apart(scene, {"outer", "inner", "mouth"}), stand);
    svg.text({165, 16}, "the generics", {20, black, true});
    svg.line(parts({-0.95, -0.3, 0}, 0, 0), parts({-1.3, -0.75, 0}), {black, 1.5});
    svg.text(parts({-1.36, -0.88, 0}), "A", {26, black, true});
    svg.line(parts({0.6, -0.6, 0}, 0, 0), parts({1.2, -0.95, 0}), {black, 1.5});
    svg.text(parts({1.27, -1.05, 0}), "B", {26, black, true});
    svg.line(parts({1.2, 1.1, 0}, 0, 0), parts({1.5, 0.6, 0}), {black, 1.5});
    svg.text(parts({1.52, 0.48, 0}), "C", {26, black, true});

    // The section at z = 0.
    const Sheet sheet{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {500, 236}, 98};
    const Workbench generics = apart(scene, {"outer", "inner", "mouth"}),
                    bowl = compounds_of(subject.bench.scene);
    const auto part = [&](std::size_t i) {
        return section(sheet, -1.1, 1.55, [&](const Ray<double>& ray) { return list_of(generics, ray, i); });
    };
    svg.text({500, 16}, "cut open at z = 0", {20, black, true});
    svg.area(part(2), {purple, 0.22});
    svg.area(section(sheet, -1.1, 1.55, [&](const Ray<double>& ray) { return list_of(bowl, ray); }),
             {blue, 0.75});
    const auto around = [&](std::size_t i, const Pen& pen) { svg.outline(part(i).at(0), pen); };
    around(0, {black, 2});
    around(1, {vermilion, 2, "8 5"});
    around(2, {Rgb{0x99, 0x45, 0x77}, 2, "2 5"});
    svg.text(sheet({-1.22, 0.25, 0}), "A", {24, black, true});
    svg.text(sheet({0.3, -0.55, 0}), "B", {24, vermilion, true});
    svg.text(sheet({0, 0.6, 0}), "C", {24, Rgb{0x99, 0x45, 0x77}, true});

    const Solid result(svg, {670, 30, 330, 360}, bowl, stand);
    svg.text({835, 16}, "what is left", {20, black, true});
    svg.text({165, 420}, "A, B: spheres, C: a cone", {20});
    svg.text({500, 420}, "A − B, opened by C", {20});
    svg.text({835, 420}, "(A − B) − C", {22, black, true});
    return svg;
}

Svg cylinder_with_holes(const Subject& subject) {
    Svg svg(900, 620);
    const Solid solid(svg, {0, 0, 900, 620}, compounds_of(subject.bench.scene),
                      {{0.35, 0.85, 0.75}, {0, 1, 0}, {0, -0.1, 0}, 1.25, 0.9, true, 1.4, {}});
    struct Hole {
        const char* name;
        Vec3d top;
    };
    for (const Hole& hole :
         {Hole{"A", {0, 0.8, 0.5}}, Hole{"B", {0.433, 0.8, -0.25}}, Hole{"C", {-0.433, 0.8, -0.25}}})
        svg.text(solid(hole.top, 0, -4), hole.name, {28, black, true});
    svg.line(solid({0.95, -0.2, 0.3}), solid({1.25, -0.2, 0.3}), {black, 2});
    svg.text(solid({1.31, -0.2, 0.3}), "D", {28, black, true});
    svg.text({450, 590}, "D − A − B − C", {26, black, true});
    return svg;
}

Svg cylinder_generics(const Subject& subject) {
    Svg svg(1000, 480);
    // Each where it was, moved aside alone, so that all four can be seen.
    Scene scene =
        coloured(subject.bench.scene, {{"D", orange}, {"A", sky_blue}, {"B", green}, {"C", purple}});
    const std::pair<const char*, double> aside[] = {{"D", -2.3}, {"A", 0.1}, {"B", 0.55}, {"C", 2.5}};
    for (SceneGeneric& generic : scene.generics)
        for (const auto& [name, x] : aside)
            if (generic.name == name) generic.matrix[3][0] += x;
    const Solid solid(svg, {0, 0, 1000, 420}, apart(scene, {"D", "A", "B", "C"}),
                      {{0.0, 0.6, 1},
                       {0, 1, 0},
                       {0, 0, 0},
                       1.9,
                       0.96,
                       true,
                       1.3,
                       {{-3.3, -0.9, 0}, {2.4, 0.9, 0}, {0, 1.3, 0}, {0, -1.3, 0}}});
    svg.text({solid({-2.3, 0, 0}).x, 395}, "D", {28, black, true});
    svg.text({solid({0.1, 0, 0}).x, 395}, "A", {28, black, true});
    svg.text({solid({0.98, 0, 0}).x, 395}, "B", {28, black, true});
    svg.text({solid({2.07, 0, 0}).x, 395}, "C", {28, black, true});
    svg.text({500, 450}, "D − A − B − C: the drills A, B and C are longer than D is high", {20});
    return svg;
}

} // namespace rayscope::figures
