#pragma once
// Meshes that tests try.

#include "core/generics/mesh.hpp"
#include "tests/support/random.hpp"

#include <numbers>

namespace rayscope::test {

[[nodiscard]] inline Mesh<double> mesh_of(MeshData data) {
    return Mesh<double>(std::make_shared<const TriangleMesh>(std::move(data)));
}

/// The generic cube: 8 vertices, 12 triangles. Triangles 2 f and 2 f + 1 make one face.
[[nodiscard]] inline MeshData cube_data(const Vec3d& middle = Vec3d{0}, double half = 1) {
    MeshData data;
    for (int i = 0; i < 8; ++i)
        data.positions.push_back(
            middle + half * Vec3d{(i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1});
    for (const std::array<std::uint32_t, 4>& q : {std::array<std::uint32_t, 4>{0, 4, 6, 2},
                                                  {1, 3, 7, 5},
                                                  {0, 1, 5, 4},
                                                  {2, 6, 7, 3},
                                                  {0, 2, 3, 1},
                                                  {4, 5, 7, 6}}) {
        data.triangles.push_back({q[0], q[1], q[2]});
        data.triangles.push_back({q[0], q[2], q[3]});
    }
    return data;
}

[[nodiscard]] inline MeshData joined(MeshData a, const MeshData& b) {
    const auto offset = std::uint32_t(a.positions.size());
    a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
    for (MeshData::Corners t : b.triangles) {
        for (std::uint32_t& corner : t) corner += offset;
        a.triangles.push_back(t);
    }
    return a;
}

/// A closed globe of about 2 · around² triangles; its radius varies by `lumps`. With the normals of a sphere.
[[nodiscard]] inline MeshData globe_data(int around, double lumps = 0) {
    MeshData data;
    const int rows = around / 2;
    const auto add = [&](double latitude, double longitude) {
        const double c = std::cos(latitude);
        const Vec3d n{c * std::cos(longitude), c * std::sin(longitude), std::sin(latitude)};
        data.positions.push_back(n * (1 + lumps * std::sin(5 * latitude) * std::cos(7 * longitude) * c));
        data.normals.push_back(as<float>(n));
    };
    add(-std::numbers::pi / 2, 0);
    for (int j = 1; j < rows; ++j)
        for (int i = 0; i < around; ++i)
            add(std::numbers::pi * (double(j) / rows - 0.5), 2 * std::numbers::pi * i / around);
    add(std::numbers::pi / 2, 0);
    const auto at = [&](int j, int i) { return std::uint32_t(1 + (j - 1) * around + i % around); };
    const auto last = std::uint32_t(data.positions.size() - 1);
    for (int i = 0; i < around; ++i) {
        data.triangles.push_back({0, at(1, i + 1), at(1, i)});
        for (int j = 1; j + 1 < rows; ++j) {
            data.triangles.push_back({at(j, i), at(j, i + 1), at(j + 1, i + 1)});
            data.triangles.push_back({at(j, i), at(j + 1, i + 1), at(j + 1, i)});
        }
        data.triangles.push_back({at(rows - 1, i), at(rows - 1, i + 1), last});
    }
    return data;
}

/// The upper part of it: a surface.
[[nodiscard]] inline MeshData bowl_data(int around) {
    MeshData data = globe_data(around);
    std::erase_if(data.triangles, [&](const MeshData::Corners& t) { return data.positions[t[0]].z > 0.2; });
    return data;
}

[[nodiscard]] inline std::vector<MeshCrossing<double>> crossings(const Mesh<double>& mesh,
                                                                 const Ray<double>& ray) {
    std::vector<MeshCrossing<double>> list;
    mesh.crossings(ray, no_face, list);
    return list;
}

} // namespace rayscope::test
