// Chapter 7: the schoolbook's formulas beside the stable ones, and the bounds for what is left of the error.

#include "core/rayscope.hpp"

#include <fmt/format.h>

using namespace rayscope;

namespace {

/// The gap between neighbouring numbers of a type: all that rounding does begins with it.
template <Scalar T> void print_type(const char* name) {
    fmt::print("  {:<12} {:>3} bits  ε = {:.2e}  numbers near 10⁶ stand {:.2e} apart\n", name,
               limits::digits<T>, double(epsilon<T>), double(epsilon<T>) * 524288);
}

void types() {
    fmt::print("Number types\n");
    print_type<float>("float");
    print_type<double>("double");
    print_type<Float128>("float128");
    fmt::print("\n");
}

/// t² − 2 b t + 1: for large b the small root is about 1 / (2 b).
template <Scalar T> void print_small_root(const char* name, T b) {
    const auto textbook = textbook_quadratic_roots(T(1), T(-2) * b, T(1));
    const auto stable = quadratic_roots(T(1), -b, T(1), sqrt(b * b - T(1)));
    const Float128 exact = Float128(1) / (Float128(b) + sqrt(Float128(b) * Float128(b) - Float128(1)));
    fmt::print("  {:<7} b = {:<7g} textbook {:<13.7g} stable {:<13.7g} exact {:.7g}\n", name, double(b),
               double(textbook->first), double(stable.first), double(exact));
}

void cancellation() {
    fmt::print("The small root of t² - 2 b t + 1\n");
    for (const float b : {10.0F, 1000.0F, 10000.0F}) print_small_root("float", b);
    for (const double b : {1e3, 1e6, 1e8}) print_small_root("double", b);
    fmt::print("\n");
}

/// The line passes the centre of a unit sphere by 0.6: it is inside for 1.6.
template <Numbers N> std::string chord(double distance) {
    using T = ScalarOf<N>;
    const Ray<T> ray{{T(-distance), T(0.6), T(0)}, {T(1), T(0), T(0)}};
    const Intervals<T> inside = Sphere<N>{}.intervals(ray);
    if (inside.count == 0) return "missed";
    return fmt::format("{:.6g}", double(inside.begin()->exit - inside.begin()->enter));
}

void far_sphere() {
    fmt::print("How long a line is inside of a far sphere; exactly 1.6\n");
    fmt::print("  distance  float textbook  float stable  double textbook  double stable\n");
    for (const double distance : {10.0, 1e3, 1e4, 1e5, 1e7, 1e8, 1e9})
        fmt::print("  {:<8g}  {:<14}  {:<12}  {:<15}  {}\n", distance, chord<Textbook<float>>(distance),
                   chord<float>(distance), chord<Textbook<double>>(distance), chord<double>(distance));
    fmt::print("\n");
}

/// Error and bound of the first crossing of a float ray with a sphere that it passes by `offset`.
void bounds() {
    fmt::print("A float ray onto a unit sphere: error and bound of t, in units of float's ε\n");
    Mat4d place{1};
    place[3] = {100, 0, 0, 1};
    const Solid<float> near{Sphere<float>{}, Transform<float>(place)};
    const Solid<Float128> exact{Sphere<Float128>{}, Transform<Float128>(place)};
    for (const float offset : {0.0F, 0.6F, 0.9F, 0.99F, 0.999F, 0.9999F}) {
        const Ray<float> ray{{0, offset, 0}, {1, 0, 0}};
        const Interval<float> inside = *near.intervals(ray).begin();
        const Float128 truth = exact.intervals(as<Float128>(ray)).begin()->enter;
        const double error = double(magnitude(Float128(inside.enter) - truth)) / double(epsilon<float>);
        const double bound = double(near.error_bound(ray, inside.enter, 0)) / double(epsilon<float>);
        fmt::print("  passes the middle by {:<7g} error {:>6.1f}  bound {:>8.1f}\n", double(offset), error,
                   bound);
    }
    fmt::print("\n");
}

/// A point of a sphere of some radius: on which side of it does the computed point lie?
void starting_points() {
    fmt::print("Computed hit points of 10000 rays on a sphere, and a constant offset of 0.0001\n");
    for (const double radius : {0.001, 1.0, 1e6, 1e12}) {
        const Sphere<double> sphere{radius};
        int inside = 0, outside = 0;
        double worst = 0;
        for (int i = 1; i <= 100; ++i)
            for (int j = 1; j <= 100; ++j) {
                const Vec3d origin = radius * Vec3d(3, 0.031 * i, 0.017 * j);
                const Ray<double> ray{origin, normalized(radius * Vec3d(0, 0.007 * j, 0.005 * i) - origin)};
                const Vec3d p = ray.at(sphere.intervals(ray).begin()->enter);
                const double off = sphere.value(p);
                inside += off < 0 ? 1 : 0;
                outside += off > 0 ? 1 : 0;
                worst = maximum(worst, magnitude(off));
            }
        fmt::print("  radius {:<6g} {:>4} inside, {:>4} outside, at most {:.0e} off; 0.0001 is {}\n", radius,
                   inside, outside, worst,
                   worst > 1e-4    ? "too small"
                   : radius < 0.01 ? "too large"
                                   : "enough");
    }
}

} // namespace

int main() {
    types();
    cancellation();
    far_sphere();
    bounds();
    starting_points();
}
