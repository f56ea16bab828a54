#pragma once
// What every exercise may use: a few types, GLM's vectors and matrices, and the parts of the standard library that
// exercises need.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace rx {

using glm::dmat3;
using glm::dmat4;
using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

inline constexpr double INF = std::numeric_limits<double>::infinity();

/// The points o + t d. d need not be unit, unless the task says so.
struct Ray {
    dvec3 o{0}, d{0};
};

/// A crossing of the boundary of object `obj` at t, with the outward normal there.
struct Hit {
    double t = 0;
    dvec3 n{0};
    bool enter = false;
    int obj = 0;
};
using Hits = std::vector<Hit>;

/// The open interval a < t < b in which a ray is inside; −INF and INF are allowed.
struct Span {
    double a = 0, b = 0;
};
/// Ascending, disjoint, not touching.
using Spans = std::vector<Span>;

/// A closed box with its faces along the axes.
struct Box {
    dvec3 lo{0}, hi{0};
};

/// Pixels; empty: {1, 1, 0, 0}.
struct Rect {
    double x0 = 1, y0 = 1, x1 = 0, y1 = 0;
};

/// A camera that looks down −z of its view space. fovy in radians, n the distance of the near plane, w × h pixels.
struct Cam {
    dmat4 view{1};
    double fovy = 0, n = 0;
    int w = 0, h = 0;
};

/// op: '.' a leaf (its number is l), '!' the complement of l, '&' '|' '-' of l and r, which are indices of nodes.
struct Node {
    char op = '.';
    int l = 0, r = 0;
};

/// A surface that a path meets: its own light and its reflection coefficient.
struct Bounce {
    dvec3 local{0};
    double kr = 0;
};

/// What happens at a wall: the normal against the ray, the speeds on the ray's side and beyond.
struct Wall {
    dvec3 n{0};
    double c1 = 0, c2 = 0;
    bool local = false, tir = false;
};

/// A path enters or leaves object `obj`.
struct Cross {
    int obj = 0;
    bool enter = false;
};

/// A cell of an octree that the ray is in from t0 to t1, and the objects in it.
struct Cell {
    double t0 = 0, t1 = 0;
    std::vector<int> objs;
};

/// The object that is hit (−1: none) and how many tests that took.
struct Found {
    int obj = -1, tests = 0;
};

/// Coefficients: diffuse, specular, reflection, transmission.
struct Mat {
    double kd = 0, ks = 0, kr = 0, kt = 0;
};

struct NotYetWritten {};
/// Stands where your code is to go.
[[noreturn]] inline void todo() { throw NotYetWritten{}; }

} // namespace rx
