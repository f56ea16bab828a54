#include "cases.hpp"

namespace {

/// Somewhere, turned about the vertical; `view` is its inverse.
struct Eye {
    dmat4 to_world;
    Cam camera;
};
Eye eye(Cases& c, bool moved) {
    dmat4 pose(1);
    if (moved) pose = glm::rotate(c.translation(3), c.between(-3, 3), dvec3(0, 1, 0));
    return {pose, {glm::inverse(pose), c.between(0.7, 1.2), 0.1, 640, 480}};
}
dmat4 at(const dvec3& place, const dvec3& half = dvec3(1)) {
    return glm::scale(glm::translate(dmat4(1), place), half);
}

} // namespace

void cases(Cases& c) {
    c.group("basic");
    for (int i = 0; i < 4; ++i) {
        const Eye e = eye(c, i % 2 != 0);
        c.add("in front of the eye", e.to_world * at({c.between(-1, 1), c.between(-1, 1), -c.between(8, 12)}),
              e.camera);
    }
    c.group("edge");
    const Eye e = eye(c, true);
    c.add("rotated", e.to_world * at({0, 0, -c.between(8, 12)}) * c.rotation(), e.camera);
    c.add("partly off the screen",
          e.to_world * at({c.sign() * c.between(5, 6), 0, -8}, dvec3(2)) * c.rotation(), e.camera);
    c.add("off the screen", e.to_world * at({c.sign() * c.between(25, 30), 0, -8}), e.camera);
    c.add("all behind the eye", e.to_world * at({0, c.between(-1, 1), c.between(8, 12)}), e.camera);
    c.group("hard");
    const Eye f = eye(c, true);
    const double right = c.between(0.6, 1);
    c.add("a beam that passes to the right", f.to_world * at({right, 0, -6}, {0.2, 0.2, c.between(10, 14)}),
          f.camera);
    c.add("a beam that passes above and to the left",
          f.to_world * at({-right, right, -6}, {0.2, 0.2, c.between(10, 14)}), f.camera);
    c.add("a slanted beam",
          f.to_world * glm::rotate(at({-0.5, -0.8, -4}, {0.3, 0.1, c.between(8, 9)}), 0.1, dvec3(0, 1, 0)),
          f.camera);
    c.add("a floor under the eye", f.to_world * at({0, -c.between(1, 2), -4}, {3, 0.1, 9}), f.camera);
    c.add("a small cube at the eye", f.to_world * at({0.05, 0, 0}, dvec3(c.between(0.3, 0.5))), f.camera);
}

namespace {

bool within(const Rect& rect, const dvec2& pixel) {
    return pixel.x > rect.x0 && pixel.x < rect.x1 && pixel.y > rect.y0 && pixel.y < rect.y1;
}

/// A ray of eye space through a place of the screen.
Ray through(const Cam& c, const dvec2& pixel) {
    const double s = c.h / (2 * std::tan(c.fovy / 2));
    return {dvec3(0), {(pixel.x - c.w / 2.0) / s, (pixel.y - c.h / 2.0) / s, -1}};
}

bool hits_cube(const Ray& r, const dmat4& to_cube) {
    const dvec3 o(to_cube * dvec4(r.o, 1)), d(to_cube * dvec4(r.d, 0));
    const dvec3 a = (dvec3(-1) - o) / d, b = (dvec3(1) - o) / d, low = glm::min(a, b), high = glm::max(a, b);
    const double end = std::min({high.x, high.y, high.z});
    return std::max({low.x, low.y, low.z}) < end && end > 0;
}

/// The middles between these places, in steps of a sixteenth.
std::vector<double> between(std::vector<double> places) {
    std::ranges::sort(places);
    std::vector<double> list;
    for (std::size_t i = 0; i + 1 < places.size(); ++i)
        for (double share = 1.0 / 32; share < 1; share += 1.0 / 16)
            list.push_back(places[i] + share * (places[i + 1] - places[i]));
    return list;
}

/// A place of the screen that is in one rectangle alone, best where the cube is seen, or else any where it is.
dvec2 telling_place(const dmat4& M, const Cam& c, const Rect& right, const Rect& answer) {
    const dmat4 to_cube = glm::inverse(c.view * M);
    const double w = c.w, h = c.h;
    const auto on = [](double most, double place) { return std::clamp(place, 0.0, most); };
    dvec2 place(w / 2, h / 2);
    int best = 0;
    for (const double y :
         between({0, on(h, right.y0), on(h, right.y1), on(h, answer.y0), on(h, answer.y1), h}))
        for (const double x :
             between({0, on(w, right.x0), on(w, right.x1), on(w, answer.x0), on(w, answer.x1), w})) {
            const bool differ = within(right, {x, y}) != within(answer, {x, y});
            const int rank = 2 * (differ ? 1 : 0) + (hits_cube(through(c, {x, y}), to_cube) ? 1 : 0);
            if (rank > best) best = rank, place = {x, y};
        }
    return place;
}

} // namespace

/// The cube, if the rectangle covers the pixel: only then it would be tested.
Shown show(const dmat4& M, const Cam& c, const Rect& right, const Rect& drawn, const Rect& answer) {
    const dvec2 pixel = telling_place(M, c, right, answer);
    const dmat4 to_world = glm::inverse(c.view);
    return {scene(within(drawn, pixel) ? generic("cube", "cube", M) : ""),
            {dvec3(to_world[3]), dvec3(to_world * dvec4(through(c, pixel).d, 0))},
            "The case has no ray. This one goes through a pixel that only one of the two rectangles covers, "
            "if there "
            "is one. The cube is tested only where its rectangle is."};
}
