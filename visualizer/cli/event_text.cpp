#include "visualizer/cli/event_text.hpp"

#include "visualizer/cli/ray_facts.hpp"

namespace rayscope::cli {
namespace {

std::string spaced(std::string_view name) {
    std::string text(name);
    for (char& c : text)
        if (c == '_') c = ' ';
    return text;
}

template <typename E> std::string word(E value) { return spaced(Words<E>::list[std::size_t(value)]); }

class Teller {
public:
    Teller(const SeenEvent& seen, const Numbers& number)
        : trace_(seen.trace), ray_(seen.traced()), number_(number) {}

    std::string operator()(const RaySpawned& e) const {
        std::string text = "a " + std::string(e.kind == RayKind::eye ? "first" : name_of(e.kind)) +
                           " ray starts at " + number_.vector(e.origin) + " towards " +
                           number_.vector(e.direction);
        if (e.kind == RayKind::shadow) return text + ", to light " + light_name(trace_, e.light);
        return text + ", depth " + std::to_string(e.depth) + ", weight " + number_.colour(e.weight) +
               ", in " + medium_name(trace_, e.medium) + of_wavelength(e.wavelength);
    }
    std::string operator()(const SearchBegan& e) const {
        return "the " + word(e.stage) + " looks for the hit among " + count(e.objects, "object");
    }
    std::string operator()(const PlaceEntered& e) const {
        const std::string part = e.kind == PlaceKind::part ? " " + std::to_string(e.place) : "";
        const std::string name =
            e.object != none
                ? word(e.kind) + part + " of " + object_name(trace_, e.object)
                : word(e.kind) + " " + std::to_string(e.place) + ", level " + std::to_string(e.level);
        return "comes to " + name + " at t = " + number_(e.t_in) + " … " + number_(e.t_out) +
               ", which holds " + std::to_string(e.held);
    }
    std::string operator()(const PlaceLeft& e) const {
        return "leaves it: " + count(e.tested, "test") + ", " + std::to_string(e.spared) + " spared";
    }
    std::string operator()(const SearchEnded& e) const {
        return "the search ends, " + word(e.reason) + ": " + count(e.tested, "test") + ", " +
               std::to_string(e.spared) + " saved";
    }
    std::string operator()(const ObjectAccepted& e) const {
        return object_name(trace_, e.object) + " has a crossing that counts, at t = " + number_(e.t);
    }
    std::string operator()(const NodeEvaluated& e) const {
        const TraceObject& object = trace_.objects[std::size_t(e.object)];
        const bool root = std::size_t(e.node) + 1 == object.nodes.size();
        const std::string name = harmless(root ? object.name : object.nodes[std::size_t(e.node)].name);
        const std::string part = root ? "" : ", a part of " + harmless(object.name);
        return e.count == 0 ? name + part + ": the ray's line is never inside"
                            : name + part + ": the ray's line is inside " +
                                  (e.count == 1 ? "once" : std::to_string(e.count) + " times");
    }
    std::string operator()(const SpanFound& e) const {
        return "inside for " + number_(e.enter.t) + " < t < " + number_(e.exit.t) +
               end(", in through ", e.enter) + end(", out through ", e.exit);
    }
    std::string operator()(const ClusterMerged& e) const {
        return count(e.count, "crossing") + " of " + object_name(trace_, e.object) +
               " from t = " + number_(e.t_first) + " to " + number_(e.t_last) +
               " lie within their error bounds: " + (e.kept ? "one stays" : "all vanish");
    }
    std::string operator()(const BoundaryChosen& e) const {
        const std::string leaf = generic_name_of(trace_, e.boundary.leaf),
                          object = object_name(trace_, e.object);
        return "the nearest crossing: " + std::string(e.entering ? "into " : "out of ") + object +
               (leaf == object ? "" : " through " + leaf) + " at t = " + number_(e.boundary.t) + " ± " +
               number_(e.error_bound) + ", point " + number_.vector(e.point) +
               ", n = " + number_.vector(e.facing);
    }
    std::string operator()(const TriangleHit& e) const { return "in triangle " + std::to_string(e.triangle); }
    std::string operator()(const Absorbed& e) const {
        return medium_name(trace_, e.medium) + " leaves " + number_.colour(e.passed) + " of the light on " +
               number_(e.length) + " of way";
    }
    std::string operator()(const FresnelShared& e) const {
        return "Fresnel: R = " + number_(e.reflected) + " is reflected, Rs = " + number_(e.perpendicular) +
               ", Rp = " + number_(e.parallel) + ", Schlick " + number_(e.schlick) +
               of_wavelength(e.wavelength);
    }
    std::string operator()(const Missed& e) const {
        return "nothing is hit: background " + number_.colour(e.background);
    }
    std::string operator()(const AmbientLit& e) const {
        return "ambient light: " + number_.colour(e.scene) + " × " + number_.colour(e.material) + " = " +
               number_.colour(e.scene * e.material);
    }
    std::string operator()(const LightLit& e) const {
        const std::string name = "light " + light_name(trace_, e.light) + ": n·l = " + number_(e.cosine);
        if (!(e.cosine > 0)) return name + ", behind the surface";
        return name + ", visibility " + number_.colour(e.visibility) + ": diffuse " +
               number_.colour(e.diffuse) + ", specular " + number_.colour(e.specular);
    }
    std::string operator()(const LocalLightSkipped&) const {
        return "no local light: the ray leaves a solid that lets light through";
    }
    std::string operator()(const BlockerPassed& e) const {
        return "the light passes " + object_name(trace_, e.object) + " at t = " + number_(e.t) + ": × " +
               number_.colour(e.transmission);
    }
    std::string operator()(const Reflected& e) const {
        return "is mirrored at θ = " + number_.degrees(e.theta) + " towards " + number_.vector(e.direction) +
               ", coefficient " + number_.colour(e.coefficient);
    }
    std::string operator()(const Refracted& e) const {
        return "is bent: θ₁ = " + number_.degrees(e.theta_from) + ", θ₂ = " + number_.degrees(e.theta_to) +
               ", towards " + number_.vector(e.direction) + ", coefficient " + number_.colour(e.coefficient) +
               of_wavelength(e.wavelength);
    }
    std::string operator()(const TotallyReflected& e) const {
        return "total internal reflection: θ₁ = " + number_.degrees(e.theta_from) +
               " is beyond the critical angle " + number_.degrees(e.critical);
    }
    std::string operator()(const NotSpawned& e) const {
        return "no " + std::string(name_of(e.kind)) + " ray: " + word(e.reason) + " (coefficient " +
               number_(e.coefficient) + ", weight " + number_.colour(e.weight) + ")";
    }
    std::string operator()(const RayFinished& e) const {
        if (ray_.start().kind == RayKind::shadow)
            return "the ray ends: visibility " + number_.colour(e.colour) + blocker(e);
        return "the ray ends: local " + number_.colour(e.local) + ", it brings back " +
               number_.colour(e.colour) + "; " + count(e.tested, "object") + " tested";
    }
    std::string operator()(const Truncated& e) const {
        return "the record is full: " + count(e.kept, "event") + " are kept";
    }

private:
    static std::string count(int number, const char* what) {
        return std::to_string(number) + " " + what + (number == 1 ? "" : "s");
    }
    /// What a shadow ray met last, if nothing of its light is left.
    [[nodiscard]] std::string blocker(const RayFinished& e) const {
        const ObjectAccepted* last = nullptr;
        for (const Event& event : ray_.events)
            if (const auto* accepted = std::get_if<ObjectAccepted>(&event)) last = accepted;
        if (last == nullptr || e.colour != Colour{0}) return "";
        return ", " + object_name(trace_, last->object) + " is in the way at t = " + number_(last->t);
    }
    [[nodiscard]] std::string end(const char* how, const Boundary& boundary) const {
        return boundary.leaf == none ? "" : how + generic_name_of(trace_, boundary.leaf);
    }

    [[nodiscard]] std::string of_wavelength(double wavelength) const {
        return wavelength > 0 ? ", " + number_(wavelength) + " nm" : "";
    }

    const Trace& trace_;
    const TracedRay& ray_;
    const Numbers& number_;
};

} // namespace

std::string event_text(const SeenEvent& seen, const StepStyle& style, bool full) {
    const std::string place = std::to_string(seen.ray) + "." + std::to_string(seen.event);
    const std::string text = std::visit(Teller(seen, style.number), seen.happened());
    Page page(style.paint);
    if (full) {
        const RayKind kind = seen.traced().start().kind;
        page.rule(style.paint.kind(kind, "ray " + std::to_string(seen.ray) + ", " + name_of(kind)) +
                  ", event " + std::to_string(seen.event) + " of " +
                  std::to_string(seen.traced().events.size() - 1) + ": " +
                  spaced(event_name(seen.happened())));
        page.line(text, 2);
        return page.text();
    }
    constexpr std::size_t text_column = 10;
    const std::string first =
        place + std::string(place.size() < text_column ? text_column - place.size() : 1, ' ');
    page.line(first, std::string(text_column, ' '), text);
    return page.text();
}

} // namespace rayscope::cli
