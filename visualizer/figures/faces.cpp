// Faces in the same place: a hole whose end is flush with the block, with a skin over it and without.

#include "visualizer/figures/figures.hpp"
#include "visualizer/figures/lanes.hpp"
#include "visualizer/figures/rays.hpp"
#include "visualizer/figures/solid.hpp"

namespace rayscope::figures {

Svg coincident_faces(const Subject& subject) {
    Svg svg(1000, 760);
    constexpr int size = 300;
    Scene scene = subject.bench.scene;
    scene.camera.field_of_view = 15; // near: the upright hole alone
    scene.camera.eye = {1.1, 4.2, 4.3};
    scene.camera.look_at = {0.375, 1, 0.25};
    const Configuration stable = own_configuration(scene), textbook = configuration("float,textbook", stable);
    struct Side {
        const Configuration& by;
        double x;
        const char *title, *how;
        Rgb colour;
    };
    for (const Side& side :
         {Side{textbook, 20, "specks of a skin are left", "no rule for rounding", vermilion},
          Side{stable, 520, "the hole is open", "within rounding, one place", green}}) {
        const drawing::Area area{side.x, 76, 460, 360};
        RenderOptions options;
        options.width = size;
        options.height = size * 360 / 460;
        svg.text({side.x + 230, 22}, side.title, {23, side.colour, true});
        svg.text({side.x + 230, 54},
                 side.how + std::string(": ") +
                     (&side.by == &textbook ? "float, textbook" : "double, stable"),
                 {18, black});
        svg.image(area, png_of(renderer(scene, side.by)(options).image));
        svg.frame(area, {side.colour, 3, &side.by == &textbook ? "10 5" : ""});
    }

    // The cut through the hole's axis, and the lists on a ray down along it.
    const Ray<double> ray{{0.375, 3, 0.25}, {0, -1, 0}};
    const Workbench generics = apart(subject.bench.scene, {"block", "upright"});
    const Sheet sheet{{0, 0, 0.25}, {1, 0, 0}, {0, 1, 0}, {160, 640}, 100};
    svg.area(section(sheet, -1.0, 1.05, [&](const Ray<double>& row) { return list_of(subject.bench, row); }),
             {orange, 0.4});
    svg.outline(
        section(sheet, -1.0, 1.05, [&](const Ray<double>& row) { return list_of(generics, row, 1); }).at(0),
        {blue, 2.5, "7 5"});
    const List block = list_of(generics, ray, 0), hole = list_of(generics, ray, 1),
               result = list_of(subject.bench, ray);
    svg.arrow(sheet(ray.at(1.25)), sheet(ray.at(result.at(0).first)), {black, 3.5});
    svg.dot(sheet(ray.at(hole.at(0).first)), 7, vermilion);
    svg.text(sheet({-0.6, -0.7, 0}), "block", {20, black, true});
    svg.text(sheet({0.375, -0.2, 0}), "drill", {20, blue, true});
    const Line line{560, 86, 0, 4.5, 46, 330};
    const double same = line(block.at(0).first);
    const double axis = draw_lanes(
        svg, line, 560, {{"block", block, orange}, {"drill", hole, blue}, {"block − drill", result, green}});
    svg.line({same, 530}, {same, axis}, {vermilion, 2, "4 5"});
    svg.text({same, 512}, "both begin at t = " + digits(block.at(0).first), {20, vermilion, true});
    return svg;
}

} // namespace rayscope::figures
