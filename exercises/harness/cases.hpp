#pragma once
// For cases.cpp of an exercise: the cases of a seed, and random numbers to make them of. The same seed gives the same
// cases on every machine.

#include "scene_text.hpp"
#include "wire.hpp"

namespace rx {

class Cases {
public:
    explicit Cases(std::uint64_t seed) : state_(seed) {}

    /// The cases that follow belong to this group of exercise.toml: "basic", "edge", "hard".
    void group(std::string_view name) { group_ = name; }
    /// The cases that follow are calls of this one of the exercise's functions, from 0.
    void function(int index) { function_ = index; }

    /// A case: what it is about, in a few words, and the arguments.
    template <typename... A> void add(std::string_view about, const A&... arguments) {
        wire::Writer call;
        wire::put(call, function_);
        (wire::put(call, arguments), ...);
        wire::put(out_, std::string_view(group_));
        wire::put(out_, about);
        wire::put(out_, std::string_view(call.bytes));
        ++count_;
    }

    [[nodiscard]] std::uint64_t bits() { // SplitMix64
        std::uint64_t z = (state_ += 0x9E3779B97F4A7C15U);
        z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
        z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
        return z ^ (z >> 31U);
    }
    [[nodiscard]] double between(double least, double most) {
        return least + (most - least) * static_cast<double>(bits() >> 11U) * 0x1p-53;
    }
    /// Both ends are possible.
    [[nodiscard]] int whole(int least, int most) {
        return least + static_cast<int>(bits() % static_cast<std::uint64_t>(most - least + 1));
    }
    [[nodiscard]] double sign() { return bits() >> 63U != 0 ? 1.0 : -1.0; }
    [[nodiscard]] dvec3 vector(double least, double most) {
        const double x = between(least, most), y = between(least, most), z = between(least, most);
        return {x, y, z};
    }
    /// Unit, every direction alike.
    [[nodiscard]] dvec3 unit() {
        for (;;) {
            const dvec3 v = vector(-1, 1);
            const double square = dot(v, v);
            if (square > 0.01 && square <= 1) return v / std::sqrt(square);
        }
    }
    /// Unit, at right angles to v.
    [[nodiscard]] dvec3 across(const dvec3& v) {
        for (;;) {
            const dvec3 u = cross(v, unit());
            if (dot(u, u) > 0.01 * dot(v, v)) return u / std::sqrt(dot(u, u));
        }
    }
    [[nodiscard]] dmat4 rotation() { return glm::rotate(dmat4(1), between(0.3, 2.8), unit()); }
    [[nodiscard]] dmat4 translation(double most = 5) { return glm::translate(dmat4(1), vector(-most, most)); }
    [[nodiscard]] static dmat4 scale(const dvec3& by) { return glm::scale(dmat4(1), by); }
    /// x grows by a share of y and z, y by a share of z.
    [[nodiscard]] dmat4 shear() {
        dmat4 m(1);
        m[1][0] = between(0.3, 1.2), m[2][0] = between(0.3, 1.2), m[2][1] = between(-1.2, -0.3);
        return m;
    }
    template <typename T> void shuffle(std::vector<T>& list) {
        for (std::size_t i = list.size(); i > 1; --i)
            std::swap(list[i - 1], list[static_cast<std::size_t>(whole(0, static_cast<int>(i) - 1))]);
    }

    void write(wire::Writer& out) const {
        out.tag('l'), out.raw(3 * count_);
        out.bytes += out_.bytes;
    }

private:
    std::uint64_t state_;
    std::string group_;
    int function_ = 0;
    std::uint32_t count_ = 0;
    wire::Writer out_;
};

/// The ray of a scene that shows a case: `scene` is a scene file's text.
struct Shown {
    std::string scene;
    Ray ray;
    std::string note{};  ///< for the student: what the ray shows, where the case itself has none
    std::string stage{}; ///< how hits are looked for, where that is what it shows: "extents", "octree"
};
template <> struct wire::Fields<Shown> {
    static constexpr const char* type = "Shown";
    template <typename V, typename F> static void visit(V& v, F f) {
        f("scene", v.scene), f("ray", v.ray), f("note", v.note), f("stage", v.stage);
    }
};

} // namespace rx
