// What does accuracy cost? The first hit of each generic, and a refraction, in each number type by each method: the time,
// in units of double stable in the same run, beside the digits that it keeps on these easy rays and loses on the oracle's
// hard cases.

#include "bench/program/benchmarks.hpp"
#include "bench/support/easy_rays.hpp"
#include "bench/support/hard_cases.hpp"
#include "bench/support/ratios.hpp"
#include "core/refraction/snell.hpp"
#include "core/scene/build.hpp"

#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>

namespace rayscope::bench {
namespace {

constexpr std::size_t ray_count = 256;
constexpr std::size_t double_stable = 2;
constexpr std::size_t float128_stable = 6;
static_assert(all_numbers[double_stable] == NumbersChoice{});
static_assert(all_numbers[float128_stable] == NumbersChoice{ScalarType::float128, Method::stable});

/// A kernel over all rays, in one choice of numbers.
struct Run {
    std::function<std::size_t()> hits; ///< what it finds, to be compared before any clock starts
    std::function<double()> worst;     ///< relative error of the worst of them; 0: none
    std::function<void(benchmark::State&)> time;
    double epsilon = 0;
};

struct Subject {
    const char* name;
    const char* families; ///< of the oracle: how their names begin
    std::function<Run(NumbersChoice)> run;
};

/// −log₁₀ of the worst relative error; NaN for float128 stable, which the others are measured against. No error is seen
/// below the type's own rounding.
double digits_kept(const Run& run, NumbersChoice numbers) {
    if (numbers == all_numbers[float128_stable]) return std::nan("");
    return -std::log10(std::max(run.worst(), run.epsilon / 2));
}

template <Numbers N>
std::shared_ptr<const World<N>> one_solid(const Generic<double>& shape, const Mat4d& matrix) {
    Scene scene;
    scene.materials.emplace_back();
    SceneGeneric& generic = scene.generics.emplace_back();
    generic.shape = shape;
    generic.matrix = matrix;
    generic.material = 0;
    scene.drawn.push_back({false, 0});
    return std::make_shared<const World<N>>(build<N>(scene));
}

template <Numbers N, Scalar T = ScalarOf<N>>
Run first_hits(const Generic<double>& shape, const Mat4d& matrix, const std::vector<Ray<double>>& given) {
    const auto world = one_solid<N>(shape, matrix);
    const auto exact = one_solid<Float128>(shape, matrix);
    auto rays = std::make_shared<std::vector<Ray<T>>>();
    for (const Ray<double>& ray : given) rays->push_back(as<T>(ray));
    Run run;
    run.epsilon = double(epsilon<T>);
    run.hits = [world, rays] {
        std::size_t count = 0;
        for (const Ray<T>& ray : *rays) count += world->solids[0].closest(ray, {}, 0).has_value();
        return count;
    };
    run.worst = [world, exact, rays] {
        double worst = 0;
        for (const Ray<T>& ray : *rays) {
            const Float128 t = exact->solids[0].closest(as<Float128>(ray), {}, 0)->t;
            const Float128 error = magnitude(Float128(world->solids[0].closest(ray, {}, 0)->t) - t);
            worst = std::max(worst, double(error / magnitude(t)));
        }
        return worst;
    };
    run.time = [world, rays](benchmark::State& state) {
        while (state.KeepRunningBatch(benchmark::IterationCount(rays->size())))
            for (const Ray<T>& ray : *rays) benchmark::DoNotOptimize(world->solids[0].closest(ray, {}, 0));
    };
    return run;
}

Subject generic(const char* name, const char* families, const Generic<double>& shape, const Mat4d& matrix) {
    const auto rays = easy_rays(shape, matrix, ray_count);
    return {name, families, [=](NumbersChoice numbers) {
                return with_numbers(numbers, [&]<Numbers N>() { return first_hits<N>(shape, matrix, rays); });
            }};
}

/// From air into glass, at up to 60° or so from the normal.
struct Boundary {
    Vec3d direction, normal;
};
std::vector<Boundary> boundaries() {
    Random random;
    std::vector<Boundary> list;
    while (list.size() < ray_count) {
        const Vec3d d = shared(normalized(random.point())), n = shared(normalized(random.point()));
        if (dot(d, n) < -0.5) list.push_back({d, n});
    }
    return list;
}
constexpr double air = 1, glass = 0.65625; // the second in 6 bits: every type knows it

template <Numbers N, Scalar T = ScalarOf<N>> Run refractions() {
    struct Bending {
        Vec3<T> direction, normal;
    };
    auto list = std::make_shared<std::vector<Bending>>();
    for (const auto& [d, n] : boundaries()) list->push_back({as<T>(d), as<T>(n)});
    Run run;
    run.epsilon = double(epsilon<T>);
    run.hits = [list] {
        std::size_t count = 0;
        for (const auto& [d, n] : *list) count += !refract<N>(d, n, T(air), T(glass)).total();
        return count;
    };
    run.worst = [list] {
        double worst = 0;
        for (const auto& [d, n] : *list) {
            const auto exact =
                refract<Float128>(as<Float128>(d), as<Float128>(n), Float128(air), Float128(glass));
            const auto found = as<Float128>(refract<N>(d, n, T(air), T(glass)).direction);
            worst = std::max(worst, double(length(found - exact.direction)));
        }
        return worst;
    };
    run.time = [list](benchmark::State& state) {
        while (state.KeepRunningBatch(benchmark::IterationCount(list->size())))
            for (const auto& [d, n] : *list) benchmark::DoNotOptimize(refract<N>(d, n, T(air), T(glass)));
    };
    return run;
}

std::vector<Subject> subjects() {
    // Scaled, sheared and moved, by numbers that a float holds.
    const Mat4d placed{{1.25, 0, 0, 0}, {0.25, 0.75, 0, 0}, {0, 0.125, 1, 0}, {0.125, -0.25, 0.375, 1}};
    Mat4d similar{1.25};
    similar[3] = placed[3];
    const Polygon<double> square({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
    return {generic("sphere", "sphere_", Sphere<double>{}, placed),
            generic("ball", "sphere_", Sphere<double>{}, similar),
            generic("plane", "plane_", Plane<double>{}, placed),
            generic("cylinder", "cylinder_", Cylinder<double>{}, placed),
            generic("cone", "cone_", Cone<double>{}, placed),
            generic("cube", "cube_", Cube<double>{}, placed),
            generic("torus", "torus_", Torus<double>{0.25}, placed),
            generic("polygon", "tri_", square, placed),
            {"refraction", "refr_", [](NumbersChoice numbers) {
                 return with_numbers(numbers, []<Numbers N>() { return refractions<N>(); });
             }}};
}

std::string title(const Subject& subject, NumbersChoice numbers) {
    return std::string(subject.name) + ", " + std::string(scalar_name(numbers.scalar)) + " " +
           std::string(method_name(numbers.method));
}

/// One line of the table; what the clock does not tell is known before it starts.
struct Row {
    std::string name, base;
    double kept = 0;
    Score hard;
};

std::string one_decimal(double number) {
    char text[32] = "–";
    if (!std::isnan(number)) std::snprintf(text, sizeof text, "%.1f", number);
    return std::string(text);
}

// A dash has one column and three bytes.
std::string aligned(const std::string& text, std::size_t width) {
    const std::size_t columns = text == "–" ? 1 : text.size();
    return std::string(width - std::min(width, columns), ' ') + text;
}

void print(const Row& row, const Times& times) {
    char ratios[64] = "";
    if (times.seconds.contains(row.base)) { // a filter may have left it out
        const double base = times.quantile(row.base, 0.5);
        const auto ratio = [&](double q) { return times.quantile(row.name, q) / base; };
        std::snprintf(ratios, sizeof ratios, "%7.2f %8.2f … %-7.2f", ratio(0.5), ratio(0), ratio(1));
    } else {
        std::snprintf(ratios, sizeof ratios, "%26s", "");
    }
    std::printf("%-30s %9.1f %s %s %s %6d of %d\n", row.name.c_str(), 1e9 * times.quantile(row.name, 0.5),
                ratios, aligned(one_decimal(row.kept), 5).c_str(),
                aligned(one_decimal(row.hard.digits_lost), 6).c_str(), row.hard.wrong, row.hard.decidable);
}

} // namespace

int accuracy_cost(const Arguments& arguments) {
    std::vector<Row> rows;
    for (const Subject& subject : subjects()) {
        const auto hard = hard_cases(subject.families);
        for (std::size_t k = 0; k < all_numbers.size(); ++k) {
            const Run run = subject.run(all_numbers[k]);
            const std::string name = title(subject, all_numbers[k]);
            if (const std::size_t hits = run.hits(); hits != ray_count) {
                std::fprintf(stderr, "%s: %zu hits, expected %zu\n", name.c_str(), hits, ray_count);
                return 1;
            }
            rows.push_back({name, title(subject, all_numbers[double_stable]),
                            digits_kept(run, all_numbers[k]), hard[k]});
            benchmark::RegisterBenchmark(name.c_str(),
                                         [run, kept = rows.back().kept](benchmark::State& state) {
                                             run.time(state);
                                             if (!std::isnan(kept)) state.counters["digits_kept"] = kept;
                                         });
        }
    }
    Arguments quick = arguments;
    quick.insert(quick.begin() + 1, "--benchmark_min_time=0.02");
    const auto times = run_interleaved(quick, 7);
    if (!times || times->names.empty()) return 2; // which was said
    std::printf("%-30s %9s %7s %9s %-9s %5s %6s %6s\n", "", "ns", "ratio", "least", "… most", "kept", "lost",
                "wrong");
    for (const Row& row : rows)
        if (times->seconds.contains(row.name)) print(row, *times);
    return 0;
}

} // namespace rayscope::bench
