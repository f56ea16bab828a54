#include "core/cases/score.hpp"

#include "core/cases/case_scene.hpp"
#include "core/cases/read_cases.hpp"
#include "core/reflection/mirror.hpp"
#include "core/refraction/snell.hpp"
#include "core/scene/build.hpp"
#include "core/tracer/object_spans.hpp"

#include <algorithm>
#include <cmath>

namespace rayscope {
namespace {

constexpr double stated_for = 64; // tolerances are for inputs that are off by so many ε …
constexpr double allowed = 4;     // … and a method that is worth its name stays within so many

enum class Verdict { right, off, wrong };

// What a case says at ε = `stated`, asked of numbers whose ε is another.
template <Numbers N> double scale_from(double stated) { return double(epsilon<ScalarOf<N>>) / stated; }

// `error` where `tolerance`, for inputs that are off by 64 ε, is proportional to ε.
Verdict judge(Score& score, double error, double tolerance) {
    score.add_error(error * stated_for / tolerance);
    return error <= tolerance * allowed / stated_for ? Verdict::right : Verdict::off;
}

template <Scalar T> Vec3<Float128> wide(const Vec3<T>& v) { return as<Float128>(v); }

double distance(const Vec3<Float128>& a, const Vec3<Float128>& b) { return double(length(a - b)); }

// Lines through solids and compounds

bool are_ordered(const std::vector<ObjectSpan>& spans) {
    Float128 last = -infinity<Float128>;
    for (const ObjectSpan& span : spans) {
        if (!(last <= span.enter.t && span.enter.t < span.exit.t)) return false; // NaN included
        last = span.exit.t;
    }
    return true;
}

Verdict judge_end(Score& score, const LineCase& exact, std::optional<std::size_t> index, Float128 t) {
    if (!index) return is_finite(t) ? Verdict::wrong : Verdict::right;
    if (!is_finite(t)) return Verdict::wrong;
    const ExactBound& bound = exact.bounds[*index];
    const double error = bound.t.distance(t), unit = bound.tight_condition * exact.epsilon;
    if (unit > 0 && std::isfinite(unit)) score.add_error(error / unit);
    return error <= bound.tight_tolerance * allowed / stated_for ? Verdict::right : Verdict::off;
}

template <Numbers N> std::optional<Verdict> verdict_on(Score& score, const LineCase& stated) {
    if (!stated.decidable || stated.in_surface) return std::nullopt;
    const LineCase exact = at_epsilon(stated, double(epsilon<ScalarOf<N>>));
    const World<N> world = build<N>(scene_of(exact));
    const auto found = object_spans(world, 0, as<ScalarOf<N>>(exact.ray));
    if (found.size() != exact.spans.size() || !are_ordered(found)) return Verdict::wrong;
    Verdict worst = Verdict::right;
    for (std::size_t i = 0; i < found.size(); ++i)
        worst = std::max({worst, judge_end(score, exact, exact.spans[i].enter, found[i].enter.t),
                          judge_end(score, exact, exact.spans[i].exit, found[i].exit.t)});
    return worst;
}

// Refraction

template <Numbers N> Refraction<ScalarOf<N>> bent(const RefractionCase& exact) {
    using T = ScalarOf<N>;
    return refract<N>(as<T>(exact.direction), as<T>(exact.normal), T(exact.speed_from), T(exact.speed_to));
}

template <Numbers N> std::optional<Verdict> verdict_on(Score& score, const RefractionCase& exact) {
    if (!exact.decidable) return std::nullopt;
    const auto found = bent<N>(exact);
    if (found.total() != exact.total || found.radicand != found.radicand) return Verdict::wrong;
    if (exact.total) return Verdict::right;
    return judge(score, distance(wide(found.direction), bent<Float128>(exact).direction),
                 exact.tolerance * scale_from<N>(exact.epsilon));
}

// Triangles

template <Numbers N> std::optional<Float128> hit(const TriangleCase& exact, const ExactTriangle& triangle) {
    Scene scene;
    scene.materials.emplace_back();
    SceneGeneric& generic = scene.generics.emplace_back();
    generic.shape = Polygon<double>(triangle.corners);
    generic.matrix = exact.matrix;
    generic.material = 0;
    scene.drawn.push_back({false, 0});
    const World<N> world = build<N>(scene);
    const auto spans = object_spans(world, 0, as<ScalarOf<N>>(exact.ray));
    if (spans.empty()) return std::nullopt;
    return spans.front().enter.t;
}

template <Numbers N>
Verdict verdict_on(Score& score, const TriangleCase& exact, const ExactTriangle& triangle,
                   const std::optional<Float128>& t) {
    const bool along = triangle.status == "parallel" || triangle.status == "coplanar";
    if (along) return t ? Verdict::wrong : Verdict::right;
    if (!triangle.decidable) return Verdict::right;
    if (t.has_value() != (triangle.status == "interior")) return Verdict::wrong;
    if (!t) return Verdict::right;
    return judge(score, triangle.t.distance(*t), triangle.tolerance * scale_from<N>(exact.epsilon));
}

template <Numbers N> std::optional<Verdict> verdict_on(Score& score, const TriangleCase& exact) {
    bool any = false;
    Verdict worst = Verdict::right;
    for (const ExactTriangle& triangle : exact.triangles) {
        const auto t = hit<N>(exact, triangle);
        any = any || t.has_value();
        worst = std::max(worst, verdict_on<N>(score, exact, triangle, t));
    }
    return exact.must_hit && !any ? Verdict::wrong : worst;
}

// Mirror cavities

template <Scalar T> struct Path {
    Ray<T> ray; // after the last bounce
    std::array<int, 3> walls{};
};

template <Numbers N> std::optional<Path<ScalarOf<N>>> followed(const CavityCase& exact) {
    using T = ScalarOf<N>;
    static const World<N> cube = [] {
        LineCase leaf;
        leaf.leaves.push_back({Cube<double>{}, Mat4d{1}});
        return build<N>(scene_of(leaf));
    }();
    Path<T> path{as<T>(exact.ray), {}};
    for (int n = 0; n < exact.bounces; ++n) {
        const auto spans = object_spans(cube, 0, path.ray);
        if (spans.size() != 1) return std::nullopt;
        const SpanEnd& wall = spans[0].exit;
        path.ray = {path.ray.at(T(wall.t)), mirrored<N>(path.ray.direction, as<T>(wall.normal))};
        ++path.walls.at(std::size_t(wall.surface.face) / 2);
    }
    return path;
}

template <Numbers N> std::optional<Verdict> verdict_on(Score& score, const CavityCase& exact) {
    const auto path = followed<N>(exact);
    if (!path || path->walls != exact.wall_counts) return Verdict::wrong;
    const auto end = followed<Float128>(exact)->ray.origin;
    return judge(score, distance(wide(path->ray.origin), end),
                 exact.tolerance * scale_from<N>(epsilon<double>));
}

template <Numbers N, typename Case> Score scored(const std::vector<Case>& cases) {
    Score score;
    for (const Case& exact : cases) {
        const std::optional<Verdict> verdict = verdict_on<N>(score, exact);
        score.decidable += verdict.has_value();
        score.wrong += verdict == Verdict::wrong;
        score.off += verdict == Verdict::off;
    }
    return score;
}

} // namespace

void Score::add_error(double in_units) {
    if (std::isnan(in_units)) return;
    const double digits = std::max(0.0, std::log10(in_units));
    if (!(digits_lost >= digits)) digits_lost = digits;
}

std::optional<Score> score(const CaseFile& file, NumbersChoice numbers) {
    return with_numbers(numbers, [&]<Numbers N>() -> std::optional<Score> {
        if (file.kind == "hit" || file.kind == "csg") return scored<N>(read_line_cases(file.path));
        if (file.kind == "refr") return scored<N>(read_refraction_cases(file.path));
        if (file.kind == "tri") return scored<N>(read_triangle_cases(file.path));
        if (file.kind == "cavity") return scored<N>(read_cavity_cases(file.path));
        return std::nullopt;
    });
}

std::vector<FamilyScores> score_folder(const std::filesystem::path& folder, const ScoreOptions& options) {
    constexpr std::string_view narrow = "_f32";
    const std::vector<CaseFile> files = case_files(folder);
    std::vector<FamilyScores> result;
    const auto row_of = [&](const CaseFile& file, bool is_narrow) -> FamilyScores& {
        std::string name = file.family;
        if (is_narrow && name.ends_with(narrow)) name.resize(name.size() - narrow.size());
        const auto found = std::ranges::find(result, name, &FamilyScores::family);
        if (found != result.end()) return *found;
        return result.emplace_back(FamilyScores{name, file.kind, {}});
    };
    for (std::size_t i = 0; i < files.size(); ++i) {
        const bool is_narrow = files[i].epsilon == double(epsilon<float>);
        FamilyScores& row = row_of(files[i], is_narrow);
        for (std::size_t k = 0; k < all_numbers.size(); ++k) {
            if (options.stop != nullptr && *options.stop) return {};
            if ((all_numbers[k].scalar == ScalarType::float32) == is_narrow)
                row.scores[k] = score(files[i], all_numbers[k]);
        }
        if (options.progress) options.progress(double(i + 1) / double(files.size()));
    }
    std::erase_if(result, [](const FamilyScores& row) {
        return std::ranges::none_of(row.scores, [](const auto& s) { return s.has_value(); });
    });
    return result;
}

} // namespace rayscope
