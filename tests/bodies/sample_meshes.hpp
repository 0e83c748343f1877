// Closed meshes for tests.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "retiarius/bodies/primitives.hpp"
#include "retiarius/bodies/shape.hpp"
#include "retiarius/bodies/triangle_nearest.hpp"

namespace retiarius::test {

inline TriangleMesh shifted(TriangleMesh mesh, const Vec3& by) {
  for (Vec3& p : mesh.vertices) p += by;
  return mesh;
}

inline TriangleMesh turned_inside_out(TriangleMesh mesh) {
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

inline TriangleMesh joined(TriangleMesh a, const TriangleMesh& b) {
  const auto first = static_cast<Index>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (auto t : b.triangles) {
    for (Index& v : t) v += first;
    a.triangles.push_back(t);
  }
  return a;
}

inline TriangleMesh box(const Vec3& size) { return make_box(size)->triangles(); }

// Octahedron whose faces are quartered `levels` times and thrown onto the sphere.
inline TriangleMesh ball(double radius, int levels) {
  TriangleMesh mesh{
      {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
      {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<Index, Index>, Index> middles;
    const auto middle = [&](Index u, Index v) {
      const auto [it, added] = middles.try_emplace(std::pair(std::min(u, v), std::max(u, v)),
                                                   static_cast<Index>(mesh.vertices.size()));
      if (added) {
        const Vec3 sum =
            mesh.vertices[static_cast<std::size_t>(u)] + mesh.vertices[static_cast<std::size_t>(v)];
        mesh.vertices.push_back(sum.normalized());
      }
      return it->second;
    };
    std::vector<std::array<Index, 3>> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = finer;
  }
  for (Vec3& p : mesh.vertices) p *= radius;
  return mesh;
}

// Ring about z: distance `large` from the axis to the tube's centre, tube radius `small`.
inline TriangleMesh ring(double large, double small, int around, int across) {
  TriangleMesh mesh;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = 2.0 * kPi * i / around, v = 2.0 * kPi * j / across;
      const double r = large + small * std::cos(v);
      mesh.vertices.emplace_back(r * std::cos(u), r * std::sin(u), small * std::sin(v));
    }
  }
  const auto at = [&](int i, int j) -> Index { return (i % around) * across + j % across; };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

// An L in the xy-plane, thick in z: the square [0, 2]^2 without [1, 2]^2, z in [0, 1].
inline TriangleMesh angle_block() {
  const std::array<Eigen::Vector2d, 6> outline = {{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}};
  TriangleMesh mesh;
  for (const double z : {0.0, 1.0}) {
    for (const auto& p : outline) mesh.vertices.emplace_back(p.x(), p.y(), z);
  }
  for (const std::array<Index, 3>& t :
       {std::array<Index, 3>{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}) {
    mesh.triangles.push_back({t[0], t[2], t[1]});
    mesh.triangles.push_back({t[0] + 6, t[1] + 6, t[2] + 6});
  }
  for (Index k = 0; k < 6; ++k) {
    const Index next = (k + 1) % 6;
    mesh.triangles.push_back({k, next, next + 6});
    mesh.triangles.push_back({k, next + 6, k + 6});
  }
  return mesh;
}

inline Corners corners_of(const TriangleMesh& mesh, std::size_t k) {
  const auto& t = mesh.triangles[k];
  return {mesh.vertices[static_cast<std::size_t>(t[0])],
          mesh.vertices[static_cast<std::size_t>(t[1])],
          mesh.vertices[static_cast<std::size_t>(t[2])]};
}

}  // namespace retiarius::test
