#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/net/check_spec.hpp"
#include "retiarius/net/counts.hpp"
#include "retiarius/net/layout.hpp"
#include "retiarius/net/network.hpp"
#include "retiarius/net/placement.hpp"

namespace retiarius {
namespace {

Material make_material(const ThreadSpec& thread) {
  Material m;
  const double r2 = thread.radius * thread.radius;
  m.young_modulus = thread.young_modulus;
  m.density = thread.density;
  m.radius = thread.radius;
  m.axial_stiffness = thread.young_modulus * kPi * r2;
  m.bending = thread.bending;
  if (thread.bending != Bending::none) {
    m.bending_stiffness =
        thread.bending_stiffness.value_or(thread.young_modulus * kPi * r2 * r2 / 4.0);
  }
  m.compression = thread.compression;
  m.damping = thread.material_damping;
  m.strength = thread.strength.value_or(kInfinity);
  m.line_density = thread.density * kPi * r2;
  return m;
}

// Material 0 is the thread's; 1 the border's, only where it differs.
std::vector<Material> make_materials(const NetSpec& spec) {
  ThreadSpec border = spec.thread;
  border.young_modulus = spec.border.young_modulus.value_or(border.young_modulus);
  border.density = spec.border.density.value_or(border.density);
  border.radius = spec.border.radius.value_or(border.radius);
  if (spec.border.bending_stiffness) border.bending_stiffness = spec.border.bending_stiffness;
  if (spec.border.strength) border.strength = spec.border.strength;
  const Material inner = make_material(spec.thread), outer = make_material(border);
  const bool same = inner.young_modulus == outer.young_modulus && inner.density == outer.density &&
                    inner.radius == outer.radius && inner.strength == outer.strength &&
                    inner.bending_stiffness == outer.bending_stiffness;
  return same ? std::vector<Material>{inner} : std::vector<Material>{inner, outer};
}

// Cuts the pieces of a layout into segments and derives everything else from them.
class Builder {
 public:
  Builder(const NetSpec& spec, Layout layout)
      : spec_(spec), layout_(std::move(layout)), is_knot_(find_knots(layout_)) {}

  Network build() {
    const NetworkCounts counts = count_layout(layout_, spec_);
    check_counts(counts, spec_);
    net_.materials = make_materials(spec_);
    net_.segments.reserve(static_cast<std::size_t>(counts.segments));
    net_.joints.reserve(static_cast<std::size_t>(counts.joints));
    place_design(static_cast<std::size_t>(counts.nodes));
    for (const Line& line : layout_.lines) add_thread(line);
    collect_names();
    add_bullets();
    add_masses();
    place_nodes(net_, spec_);
    return std::move(net_);
  }

 private:
  int inner() const { return spec_.segments - 1; }

  Index border_material() const { return static_cast<Index>(net_.materials.size()) - 1; }

  // Node number `t` of a piece, counted from its start; 0 and `segments` are its ends.
  Index node_of(Index piece, int t) const {
    if (t == 0) return layout_.pieces[piece].a;
    if (t == spec_.segments) return layout_.pieces[piece].b;
    return static_cast<Index>(layout_.nodes.size()) + piece * inner() + t - 1;
  }

  void place_design(std::size_t total) {
    net_.design.reserve(total);
    net_.design = layout_.nodes;
    for (const Piece& piece : layout_.pieces) {
      add_between(layout_.nodes[piece.a], layout_.nodes[piece.b], spec_.segments, inner());
    }
  }

  // Appends `count` nodes that follow `from` in steps of 1 / segments of the way to `to`.
  void add_between(const Vec3& from, const Vec3& to, int segments, int count) {
    for (int t = 1; t <= count; ++t) {
      net_.design.push_back((double(segments - t) * from + double(t) * to) / double(segments));
    }
  }

  void add_segment(Thread& thread, Index to, double length, Index material) {
    const auto index = static_cast<Index>(net_.segments.size());
    const auto owner = static_cast<Index>(net_.threads.size());
    net_.segments.push_back({thread.nodes.back(), to, length, material, owner});
    thread.segments.push_back(index);
    thread.nodes.push_back(to);
  }

  void add_joint(Index first, Index second) {
    const Segment &one = net_.segments[first], &two = net_.segments[second];
    Joint joint;
    joint.a = one.a;
    joint.b = one.b;
    joint.c = two.b;
    joint.first = first;
    joint.second = second;
    joint.voronoi_length = (one.rest_length + two.rest_length) / 2.0;
    joint.bending_stiffness = (net_.materials[one.material].bending_stiffness +
                               net_.materials[two.material].bending_stiffness) /
                              2.0;
    net_.joints.push_back(joint);
  }

  void add_thread(const Line& line) {
    Thread thread;
    thread.perimeter = line.border;
    thread.nodes.reserve(std::size_t(line.piece_count()) * spec_.segments + 1);
    thread.segments.reserve(std::size_t(line.piece_count()) * spec_.segments);
    thread.nodes.push_back(line.nodes.front());
    const Index last = line.first_piece + line.piece_count() - 1;
    for (Index p = line.first_piece; p <= last; ++p) {
      const Piece& piece = layout_.pieces[p];
      const bool joined =
          p > line.first_piece && keeps_joint(layout_, is_knot_, spec_.knots, p - 1, p);
      for (int t = 1; t <= spec_.segments; ++t) {
        add_segment(thread, node_of(p, t), piece.rest_length / spec_.segments,
                    piece.border ? border_material() : 0);
        const auto index = static_cast<Index>(net_.segments.size()) - 1;
        if (t > 1 || joined) add_joint(index - 1, index);
      }
    }
    if (line.closed() && keeps_joint(layout_, is_knot_, spec_.knots, last, line.first_piece)) {
      add_joint(thread.segments.back(), thread.segments.front());
    }
    net_.threads.push_back(std::move(thread));
  }

  void collect_names() {
    for (std::size_t i = 0; i < is_knot_.size(); ++i) {
      if (is_knot_[i]) net_.knots.push_back(static_cast<Index>(i));
    }
    net_.corners = layout_.corners;
    net_.center = find_center();
    Index node = layout_.outline.empty() ? kNone : layout_.corners.front();
    for (const Index p : layout_.outline) {
      const bool forward = layout_.pieces[p].a == node;
      for (int t = 0; t < spec_.segments; ++t) {
        net_.perimeter.push_back(node_of(p, forward ? t : spec_.segments - t));
      }
      node = forward ? layout_.pieces[p].b : layout_.pieces[p].a;
    }
  }

  // A closed loop without crossings has no knots: then any of its planned nodes may be the centre.
  Index find_center() const {
    const bool all = net_.knots.empty();
    Vec3 centroid = Vec3::Zero();
    double count = 0.0;
    for (std::size_t i = 0; i < is_knot_.size(); ++i) {
      if (!all && !is_knot_[i]) continue;
      centroid += layout_.nodes[i];
      ++count;
    }
    centroid /= count;
    Index best = kNone;
    double least = kInfinity;
    // Rounding must not decide between knots that are equally near.
    const double margin = 1e-9 * layout_.pieces.front().rest_length;
    for (std::size_t i = 0; i < is_knot_.size(); ++i) {
      if (!all && !is_knot_[i]) continue;
      const double distance = (layout_.nodes[i] - centroid).norm();
      if (distance < least - margin) {
        least = distance;
        best = static_cast<Index>(i);
      }
    }
    return best;
  }

  void add_bullets() {
    const CornerMassSpec& spec = spec_.corner_mass;
    if (net_.corners.empty() && (spec.mass > 0.0 || spec.bridle > 0.0)) {
      throw InputError(
          fmt::format("net.corner_mass.mass = {:.12g}: the net has no corners; name "
                      "them in its file with `corner N`",
                      spec.mass));
    }
    if (!(spec.bridle > 0.0)) {
      net_.bullets = net_.corners;
      return;
    }
    for (const Index corner : net_.corners) add_bridle(corner);
  }

  // A straight line outward from the corner in the net's plane; the bullet is its last node.
  void add_bridle(Index corner) {
    const CornerMassSpec& spec = spec_.corner_mass;
    const Vec3 from = net_.design[corner];
    const Vec3 outward = Vec3(from.x(), from.y(), 0.0);
    if (!(outward.norm() > 0.0)) {
      throw InputError(
          fmt::format("net.corner_mass.bridle = {:.12g}: corner node {} lies in the net's centre",
                      spec.bridle, corner));
    }
    const auto first = static_cast<Index>(net_.design.size());
    const int count = spec.bridle_segments;
    add_between(from, from + spec.bridle * outward.normalized(), count, count);
    Thread thread;
    thread.nodes.push_back(corner);
    for (int t = 0; t < count; ++t) {
      add_segment(thread, first + t, spec.bridle / count, border_material());
      const auto index = static_cast<Index>(net_.segments.size()) - 1;
      if (t > 0) add_joint(index - 1, index);
    }
    net_.bullets.push_back(thread.nodes.back());
    net_.threads.push_back(std::move(thread));
  }

  void add_masses() {
    net_.mass.assign(net_.design.size(), 0.0);
    std::copy(layout_.node_mass.begin(), layout_.node_mass.end(), net_.mass.begin());
    for (const Segment& s : net_.segments) {
      const double half = net_.materials[s.material].line_density * s.rest_length / 2.0;
      net_.mass[s.a] += half;
      net_.mass[s.b] += half;
    }
    for (const Index knot : net_.knots) net_.mass[knot] += spec_.knot_mass;
    for (const Index bullet : net_.bullets) net_.mass[bullet] += spec_.corner_mass.mass;
  }

  const NetSpec& spec_;
  Layout layout_;
  std::vector<char> is_knot_;
  Network net_;
};

}  // namespace

Network build_network(const NetSpec& spec) {
  check_spec(spec);
  // Before the layout, which may itself be too large to number; files are as large as they are.
  if (spec.pattern != Pattern::file) check_counts(count_network(spec), spec);
  return Builder(spec, make_layout(spec)).build();
}

}  // namespace retiarius
