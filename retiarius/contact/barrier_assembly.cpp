// The potential of barrier contact and its derivatives.
#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "retiarius/base/parallel.hpp"
#include "retiarius/contact/barrier.hpp"
#include "retiarius/contact/barrier_function.hpp"

namespace retiarius {

namespace {

// d(turn of the world) / d(rotation vector): the left Jacobian of the rotation group,
// I + (1 - cos t)/t^2 [v]x + (t - sin t)/t^3 [v]x^2.
Mat3 left_jacobian(const Vec3& v) {
  const double t2 = v.squaredNorm();
  const double t = std::sqrt(t2);
  double a = 0.5 - t2 / 24.0, b = 1.0 / 6.0 - t2 / 120.0;
  if (t > 1e-2) {
    a = (1.0 - std::cos(t)) / t2;
    b = (t - std::sin(t)) / (t2 * t);
  }
  const Mat3 s = skew(v);
  return Mat3::Identity() + a * s + b * s * s;
}

// Of points i and j.
auto block_of(const Mat12& hessian, Eigen::Index i, Eigen::Index j) {
  return hessian.block<3, 3>(3 * i, 3 * j);
}

// Makes it the nearest matrix without negative eigenvalues.
template <int size>
void drop_negative(Eigen::Ref<Eigen::Matrix<double, size, size>, 0, Eigen::OuterStride<>> matrix) {
  using Matrix = Eigen::Matrix<double, size, size>;
  const Eigen::SelfAdjointEigenSolver<Matrix> parts(matrix);
  matrix = parts.eigenvectors() * parts.eigenvalues().cwiseMax(0.0).asDiagonal() *
           parts.eigenvectors().transpose();
}

// Of four points' coordinates, those of their mean and of three combinations that a common motion
// leaves at zero: (1 1 1 1), (1 1 -1 -1), (1 -1 1 -1), (1 -1 -1 1), halved. Its own inverse.
void combine(Mat12& m) {
  const auto mix = [&](auto part) {
    const auto a = (part(0) + part(1)).eval(), b = (part(0) - part(1)).eval();
    const auto c = (part(2) + part(3)).eval(), d = (part(2) - part(3)).eval();
    part(0) = 0.5 * (a + c);
    part(1) = 0.5 * (a - c);
    part(2) = 0.5 * (b + d);
    part(3) = 0.5 * (b - d);
  };
  mix([&](int k) { return m.middleRows<3>(3L * k); });
  mix([&](int k) { return m.middleCols<3>(3L * k); });
}

// What is left of the distance's own curvature without negative eigenvalues keeps Newton's steps
// from sliding along a contact into another: where edges are nearly parallel the distance falls
// with the square of such a slide, steeply. A common motion of four points changes nothing: nine
// of twelve dimensions are left.
void drop_negative_curvature(Mat12& hessian, int count) {
  if (count < 4) return drop_negative<12>(hessian);
  combine(hessian);
  drop_negative<9>(hessian.bottomRightCorner<9, 9>());
  hessian.topRows<3>().setZero();
  hessian.leftCols<3>().setZero();
  combine(hessian);
}

}  // namespace

void BarrierContact::place_bodies(const ContactPlaces& at) {
  for (std::size_t b = 0; b < body_places_.size(); ++b) {
    const BodyState& pose = (*at.bodies)[b];
    BodyPlace& place = body_places_[b];
    place.position = pose.position;
    place.attitude = pose.attitude.toRotationMatrix();
    place.moves = !(*bodies_)[b].fixed;
    if (place.moves) place.turning = left_jacobian((*at.turns)[b]);
  }
}

Vec3 BarrierContact::world(const PointPlace& place, const ContactPlaces& at) const {
  if (place.owner == kNet) return (*at.nodes)[place.point];
  const BodyPlace& body = body_places_[static_cast<std::size_t>(place.owner)];
  return body.position +
         body.attitude * scene_.bodies[static_cast<std::size_t>(place.owner)].points[place.point];
}

// Terms are computed side by side and added one after the other.
double BarrierContact::evaluate(const ContactPlaces& at, ContactAssembly* out) {
  place_bodies(at);
  mark_near(at);
  const std::vector<ContactPair>& pairs = broad_->pairs();
  terms_.resize(near_.size() + sliding_.size());
  parallel_for(terms_.size(), kTermGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      if (k < near_.size()) {
        barrier_term(pairs[near_[k]], at, out, terms_[k]);
      } else {
        friction_term(sliding_[k - near_.size()], at, out, terms_[k]);
      }
    }
  });
  double value = 0.0;
  force_round_off_ = 0.0;
  for (const Term& term : terms_) {
    value += term.energy;
    force_round_off_ = std::max(force_round_off_, term.round_off);
    if (out && term.count > 0) scatter(term, at, *out);
  }
  return value;
}

// Most candidates are not in contact; these are sorted out side by side, most of them by what is
// known of the way that leads here. Does nothing at the place last asked for.
void BarrierContact::mark_near(const ContactPlaces& at) {
  const bool again = is_last_evaluated(at);
  if (again && near_is_known_) return;
  const std::vector<ContactPair>& pairs = broad_->pairs();
  is_near_.resize(pairs.size());
  gaps_.resize(pairs.size());
  const bool bounded = floors_.size() == pairs.size();
  const double apart = (1.0 + 1e-9) * range_;
  parallel_for(pairs.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      double least = bounded ? floors_[k] : -kInfinity;
      if (again) least = std::max(least, gaps_[k]);
      gaps_[k] = least > apart ? least : gap(pairs[k], at);
      is_near_[k] = !(gaps_[k] >= range_);
    }
  });
  evaluated_nodes_ = *at.nodes;
  evaluated_bodies_ = *at.bodies;
  near_is_known_ = true;
  near_.clear();
  for (std::size_t k = 0; k < pairs.size(); ++k)
    if (is_near_[k]) near_.push_back(k);
}

// Whether the pair is within the barrier's range (or interpenetrates), with what it needs then.
bool BarrierContact::is_near(const ContactPair& pair, const ContactPlaces& at, bool derivatives,
                             Near& near) const {
  near.p = scene_.positions(pair, *at.nodes, *at.bodies);
  near.distance = distance(pair.kind, near.p);
  near.gap = near.distance.value - scene_.thickness(pair);
  if (!(near.gap < range_)) return false;
  near.places = scene_.places(pair);
  near.stiffness = stiffness(pair, near.places);
  near.edges = pair.kind == PairKind::edge_edge;
  near.weight = {};
  if (near.edges) {
    const auto [first, second] = scene_.edge_lengths(pair);
    const double threshold = edge_weight_threshold(first, second);
    if (derivatives) {
      near.weight = edge_weight(near.p, threshold);
    } else {
      near.weight.value = edge_weight_value(near.p, threshold);
    }
  }
  const Jet b = barrier(near.gap, range_);
  near.energy = near.gap > 0.0 ? near.stiffness * near.weight.value * b.value : kInfinity;
  near.slope = near.stiffness * b.first;
  near.curvature = near.stiffness * b.second;
  near.force = -near.weight.value * near.slope;
  if (derivatives)
    near.gradient = near.weight.value * near.slope * distance_gradient(near.distance) +
                    near.stiffness * b.value * near.weight.gradient;
  return true;
}

const BarrierContact::Foretold* BarrierContact::foretold(const ContactPair& pair) const {
  const auto at =
      std::lower_bound(foretold_.begin(), foretold_.end(), pair,
                       [](const Foretold& f, const ContactPair& p) { return f.pair < p; });
  return at != foretold_.end() && at->pair == pair ? &*at : nullptr;
}

void BarrierContact::note_direction(const ContactPlaces& from, const ContactPlaces& to) {
  next_foretold_.resize(near_.size());
  parallel_for(near_.size(), kTermGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Term& term = terms_[k];
      const PairPositions p = scene_.positions(term.pair, *from.nodes, *from.bodies);
      const PairPositions q = scene_.positions(term.pair, *to.nodes, *to.bodies);
      double widening = 0.0;
      for (int i = 0; i < term.count; ++i)
        widening += term.widening.segment<3>(3L * i).dot(q[i] - p[i]);
      next_foretold_[k] = {term.pair, std::max(0.0, term.push - term.bend * widening)};
    }
  });
  foretold_.swap(next_foretold_);
  place_bodies(from);
  for (Sliding& s : sliding_) s.before = slip(s, from);
}

void BarrierContact::barrier_term(const ContactPair& pair, const ContactPlaces& at,
                                  const ContactAssembly* out, Term& term) const {
  term.count = 0;
  term.energy = term.round_off = 0.0;
  Near near;
  if (!is_near(pair, at, out != nullptr, near)) return;
  term.energy = near.energy;
  if (!out || near.energy == kInfinity) return;
  term.places = near.places;
  term.count = point_count(pair.kind);
  term.gradient = near.gradient;
  double farthest = 0.0;
  for (int i = 0; i < term.count; ++i)
    farthest = std::max(farthest, near.p[i].cwiseAbs().maxCoeff());
  const double m = near.weight.value;
  term.round_off = 4.0 * std::numeric_limits<double>::epsilon() * farthest * m * near.curvature;
  if (!out->hessian) return;
  Mat12& hessian = term.hessian;
  const Vec12 dd = distance_gradient(near.distance);
  const Foretold* known = foretold(pair);
  const Jet b = known ? foretold_barrier(near.gap, range_, known->push) : barrier(near.gap, range_);
  term.pair = pair;
  term.widening = dd;
  term.push = -near.slope / near.stiffness;
  term.bend = b.second;
  hessian.noalias() = (near.stiffness * m * b.second) * dd * dd.transpose();
  hessian += (near.stiffness * m * b.first) * distance_hessian(near.distance, near.p);
  if (near.edges && m < 1.0) {
    const Mat12 cross = near.weight.gradient * dd.transpose();
    hessian +=
        near.slope * (cross + cross.transpose()) + near.stiffness * b.value * near.weight.hessian;
  }
  if (out->definite) drop_negative_curvature(hessian, term.count);
}

// Adds a pair's derivatives in its points' coordinates to what the points belong to. A body's point
// r from its mass centre moves by A (translation, rotation vector), A = [I, -[r]x J].
void BarrierContact::scatter(const Term& term, const ContactPlaces& at,
                             ContactAssembly& out) const {
  const std::array<PointPlace, 4>& places = term.places;
  const int count = term.count;
  std::array<Mat36, 4> moves;
  std::array<Index, 4> body{kNone, kNone, kNone, kNone};
  for (int i = 0; i < count; ++i) {
    const Vec3 g = term.gradient.segment<3>(Eigen::Index{3} * i);
    if (places[i].owner == kNet) {
      (*out.gradient)[places[i].point] += g;
      continue;
    }
    const BodyPlace& b = body_places_[static_cast<std::size_t>(places[i].owner)];
    if (!b.moves) continue;
    body[i] = places[i].owner;
    const Vec3 r = world(places[i], at) - b.position;
    moves[i] << Mat3::Identity(), -skew(r) * b.turning;
    (*out.body_gradient)[static_cast<std::size_t>(body[i])] += moves[i].transpose() * g;
    if (out.hessian && !out.definite) {
      // Of the turning point itself, at rest: sum of g.(t x (t x r)) / 2.
      Mat6 own = Mat6::Zero();
      own.bottomRightCorner<3, 3>() =
          0.5 * (g * r.transpose() + r * g.transpose()) - g.dot(r) * Mat3::Identity();
      out.body_body->push_back({body[i], body[i], out.scale * own});
    }
  }
  if (!out.hessian) return;
  scatter_net(places, count, term.hessian, out);
  // The points of one primitive belong to one body.
  for (int begin = 0; begin < count;) {
    int end = begin + 1;
    while (end < count && places[end].owner == places[begin].owner) ++end;
    if (body[begin] != kNone) scatter_body(places, body, begin, end, moves, term.hessian, out);
    begin = end;
  }
}

// The blocks of pairs of nodes.
void BarrierContact::scatter_net(const std::array<PointPlace, 4>& places, int count,
                                 const Mat12& hessian, ContactAssembly& out) const {
  for (int i = 0; i < count; ++i) {
    if (places[i].owner != kNet) continue;
    const Index a = places[i].point;
    out.hessian->diagonal[a] += out.scale * block_of(hessian, i, i);
    for (int j = 0; j < count; ++j) {
      const Index c = places[j].point;
      if (places[j].owner != kNet || a <= c) continue;
      out.hessian->below[out.hessian->pattern->slot(a, c)] += out.scale * block_of(hessian, i, j);
    }
  }
}

// What the points [begin, end) of a body that moves do to all points.
void BarrierContact::scatter_body(const std::array<PointPlace, 4>& places,
                                  const std::array<Index, 4>& body, int begin, int end,
                                  const std::array<Mat36, 4>& moves, const Mat12& hessian,
                                  ContactAssembly& out) const {
  Mat6 own = Mat6::Zero(), other = Mat6::Zero();
  Index partner = kNone;
  for (int i = 0; i < 4; ++i) {
    const bool net = i < begin ? places[i].owner == kNet : i >= end && places[i].owner == kNet;
    if (places[i].point == kNone || (!net && body[i] == kNone)) continue;
    Mat36 row = Mat36::Zero();
    for (int j = begin; j < end; ++j)
      row.noalias() += out.scale * block_of(hessian, i, j) * moves[j];
    if (net) {
      out.node_body->push_back({places[i].point, body[begin], row});
    } else if (i >= begin && i < end) {
      own.noalias() += moves[i].transpose() * row;
    } else if (body[i] < body[begin]) {
      other.noalias() += moves[i].transpose() * row;
      partner = body[i];
    }
  }
  out.body_body->push_back({body[begin], body[begin], own});
  if (partner != kNone) out.body_body->push_back({partner, body[begin], other});
}

}  // namespace retiarius
