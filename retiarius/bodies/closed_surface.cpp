#include "retiarius/bodies/closed_surface.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/bodies/merge_vertices.hpp"
#include "retiarius/bodies/mesh_solid.hpp"

namespace retiarius {
namespace {

std::string text_of(const Vec3& p) {
  return fmt::format("({:g}, {:g}, {:g})", p.x(), p.y(), p.z());
}

// A triangle's side between two vertices, first < second.
struct Side {
  Index first, second;
  Index triangle;
  bool forward;  // the triangle runs from first to second

  std::pair<Index, Index> edge() const { return {first, second}; }
};

class Surface {
 public:
  Surface(TriangleMesh mesh, const std::string& file) : mesh_(std::move(mesh)), file_(file) {}

  TriangleMesh close() {
    check_areas();
    find_sides();
    check_edges();
    check_vertices();
    orient_parts();
    orient_outward();
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw InputError(SourcePlace{file_}, message);
  }
  const Vec3& point(Index v) const { return mesh_.vertices[static_cast<std::size_t>(v)]; }
  std::array<Index, 3>& triangle(Index t) { return mesh_.triangles[static_cast<std::size_t>(t)]; }
  std::string edge_text(const Side& s) const {
    return text_of(point(s.first)) + " - " + text_of(point(s.second));
  }

  void check_areas() const {
    const double least = 1e-9 * mesh_size(mesh_);
    for (std::size_t k = 0; k < mesh_.triangles.size(); ++k) {
      const auto& t = mesh_.triangles[k];
      const Vec3 a = point(t[0]), b = point(t[1]), c = point(t[2]);
      const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
      if ((b - a).cross(c - a).norm() > least * longest) continue;
      fail(fmt::format("triangle {} at {} has no area; remove it or repair the mesh", k + 1,
                       text_of(a)));
    }
  }

  void find_sides() {
    for (std::size_t k = 0; k < mesh_.triangles.size(); ++k) {
      const auto& t = mesh_.triangles[k];
      for (std::size_t j = 0; j < 3; ++j) {
        const Index u = t[j], v = t[(j + 1) % 3];
        sides_.push_back({std::min(u, v), std::max(u, v), static_cast<Index>(k), u < v});
      }
    }
    std::stable_sort(sides_.begin(), sides_.end(),
                     [](const Side& l, const Side& r) { return l.edge() < r.edge(); });
  }

  // After this the sides come in pairs.
  void check_edges() const {
    std::size_t open = 0;
    const Side* first_open = nullptr;
    for (std::size_t k = 0; k < sides_.size();) {
      std::size_t end = k + 1;
      while (end < sides_.size() && sides_[end].edge() == sides_[k].edge()) ++end;
      if (end - k > 2) {
        fail(
            fmt::format("the edge {} belongs to {} triangles; in a closed surface every edge "
                        "belongs to two",
                        edge_text(sides_[k]), end - k));
      }
      if (end - k == 1 && open++ == 0) first_open = &sides_[k];
      k = end;
    }
    if (open == 0) return;
    fail(fmt::format("the surface is not closed: {} open edge{}, the first is {}; close the holes",
                     open, open == 1 ? "" : "s", edge_text(*first_open)));
  }

  // Corners of triangles that share an edge belong to one fan; a vertex may have only one.
  void check_vertices() const {
    std::vector<std::size_t> root(3 * mesh_.triangles.size());
    std::iota(root.begin(), root.end(), 0u);
    const auto find = [&](std::size_t k) {
      while (root[k] != k) k = root[k] = root[root[k]];
      return k;
    };
    const auto corner = [&](Index t, Index v) {
      const auto& vertices = mesh_.triangles[static_cast<std::size_t>(t)];
      const auto j = std::find(vertices.begin(), vertices.end(), v) - vertices.begin();
      return 3 * static_cast<std::size_t>(t) + static_cast<std::size_t>(j);
    };
    for (std::size_t k = 0; k < sides_.size(); k += 2) {
      for (const Index v : {sides_[k].first, sides_[k].second}) {
        root[find(corner(sides_[k].triangle, v))] = find(corner(sides_[k + 1].triangle, v));
      }
    }
    std::vector<std::size_t> fan(mesh_.vertices.size(), root.size());
    for (std::size_t k = 0; k < root.size(); ++k) {
      const Index v = mesh_.triangles[k / 3][k % 3];
      std::size_t& known = fan[static_cast<std::size_t>(v)];
      if (known == root.size()) known = find(k);
      if (known == find(k)) continue;
      fail(
          fmt::format("the surface touches itself at the vertex {}; move its parts apart or join "
                      "them",
                      text_of(point(v))));
    }
  }

  // Turns triangles until neighbours agree, part by part.
  void orient_parts() {
    std::vector<std::vector<std::pair<Index, bool>>> neighbours(mesh_.triangles.size());
    for (std::size_t k = 0; k < sides_.size(); k += 2) {
      const Side &l = sides_[k], &r = sides_[k + 1];
      const bool agree = l.forward != r.forward;
      neighbours[static_cast<std::size_t>(l.triangle)].emplace_back(r.triangle, agree);
      neighbours[static_cast<std::size_t>(r.triangle)].emplace_back(l.triangle, agree);
    }
    std::vector<int> turned(mesh_.triangles.size(), -1);
    for (std::size_t start = 0; start < turned.size(); ++start) {
      if (turned[start] >= 0) continue;
      turned[start] = 0;
      parts_.push_back({static_cast<Index>(start)});
      std::vector<Index>& part = parts_.back();
      for (std::size_t k = 0; k < part.size(); ++k) {
        const auto here = static_cast<std::size_t>(part[k]);
        for (const auto& [next, agree] : neighbours[here]) {
          int& there = turned[static_cast<std::size_t>(next)];
          const int wanted = agree ? turned[here] : 1 - turned[here];
          if (there < 0) part.push_back(next);
          if (there >= 0 && there != wanted) {
            fail(fmt::format("the surface cannot be oriented (it has one side only) at {}",
                             text_of(point(mesh_.triangles[here][0]))));
          }
          there = wanted;
        }
      }
    }
    for (std::size_t k = 0; k < turned.size(); ++k) {
      if (turned[k] == 1) std::swap(mesh_.triangles[k][1], mesh_.triangles[k][2]);
    }
  }

  double volume_of(const std::vector<Index>& part) {
    const Vec3 origin = point(triangle(part[0])[0]);
    double volume = 0.0;
    for (const Index t : part) {
      const Vec3 a = point(triangle(t)[0]) - origin, b = point(triangle(t)[1]) - origin,
                 c = point(triangle(t)[2]) - origin;
      volume += a.dot(b.cross(c)) / 6.0;
    }
    return volume;
  }

  void turn(const std::vector<Index>& part) {
    for (const Index t : part) std::swap(triangle(t)[1], triangle(t)[2]);
  }

  void orient_outward() {
    const double least = 1e-12 * std::pow(mesh_size(mesh_), 3);
    if (mesh_solid(mesh_).volume < 0.0) {
      for (const auto& part : parts_) turn(part);
    }
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      const double volume = volume_of(parts_[k]);
      const Vec3& somewhere = point(triangle(parts_[k][0])[0]);
      if (std::abs(volume) <= least) {
        fail(fmt::format("the closed part at {} encloses no volume", text_of(somewhere)));
      }
      const int depth = parts_.size() > 1 ? depth_of(k) : 0;
      if ((volume > 0.0) == (depth % 2 == 0)) continue;
      if (depth > 0) {
        fail(
            fmt::format("the closed part at {} lies inside another but is not oriented as the wall "
                        "of a cavity; remove or turn it",
                        text_of(somewhere)));
      }
      turn(parts_[k]);
    }
    if (mesh_solid(mesh_).volume <= least) fail("the surface encloses no volume");
  }

  // In how many other parts a part lies, judged by one of its vertices.
  int depth_of(std::size_t part) {
    const Vec3& p = point(triangle(parts_[part][0])[0]);
    int depth = 0;
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      if (k != part && std::abs(winding(parts_[k], p)) > 0.5) ++depth;
    }
    return depth;
  }

  // Winding number of a part about a point: its solid angle (van Oosterom & Strackee 1983) / 4 pi.
  double winding(const std::vector<Index>& part, const Vec3& p) {
    double angle = 0.0;
    for (const Index t : part) {
      const Vec3 a = point(triangle(t)[0]) - p, b = point(triangle(t)[1]) - p,
                 c = point(triangle(t)[2]) - p;
      const double la = a.norm(), lb = b.norm(), lc = c.norm();
      angle += 2.0 * std::atan2(a.dot(b.cross(c)),
                                la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
    return angle / (4.0 * kPi);
  }

  TriangleMesh mesh_;
  std::string file_;
  std::vector<Side> sides_;
  std::vector<std::vector<Index>> parts_;
};

}  // namespace

TriangleMesh closed_surface(const TriangleMesh& loose, const std::string& file) {
  const double tolerance = 1e-9 * mesh_size(loose);
  if (!(tolerance > 0.0)) {
    throw InputError(SourcePlace{file}, "the mesh has no extent: all its points are one");
  }
  return Surface(merge_vertices(loose, tolerance), file).close();
}

}  // namespace retiarius
