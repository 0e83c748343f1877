#include "retiarius/forces/stretching.hpp"

#include <algorithm>
#include <cmath>

#include "retiarius/forces/element_sums.hpp"

namespace retiarius {

namespace {

// Of relax(): the most sweeps, and the strain up to which segments are left as they are.
constexpr int kMostSweeps = 30;
constexpr double kLeftStrain = 1e-3;

// Threads that are foretold to be taut are not held where they are slacker than this strain.
constexpr double kHeldSlack = 1e-3;

// Rate of the strain at the start of the step, from the start's velocities, 1/s.
double start_rate(const State& s, Index a, Index b, double rest_length) {
  const Vec3 e = s.x[b] - s.x[a];
  const double l = e.norm();
  return l > 0.0 ? e.dot(s.v[b] - s.v[a]) / (l * rest_length) : 0.0;
}

// Where the start's velocity leads a segment until the stage, the rate of its strain is that of the
// stage velocities there; returned is what it has besides step.rate times the strain's change. The
// stage itself lies away by O(h^2), and the rate is linear in that: it is of second order.
double predicted_offset(const Step& step, Index a, Index b, double rest_length) {
  const State& s = *step.start;
  const double time = step.h / step.reach;
  const Vec3 ya = s.x[a] + time * s.v[a], yb = s.x[b] + time * s.v[b];
  const Vec3 e = yb - ya;
  const double l = e.norm();
  if (l == 0.0) return 0.0;
  const Vec3 w = step.stage_velocity(b, yb) - step.stage_velocity(a, ya);
  return (e.dot(w) / l - step.rate * (l - (s.x[b] - s.x[a]).norm())) / rest_length;
}

// The part of the strain rate that does not depend on the stage, 1/s. With it trapezoid and
// midpoint are of second order: the midpoint's stage lies on the chord from x0 to x1, and a
// segment that turns is shorter there by h^2 |P dv|^2 / 8l.
double rate_offset(const Step& step, Index a, Index b, double rest_length) {
  const State& s = *step.start;
  switch (step.strain_rate) {
    case Step::StrainRate::trapezoid:
      return -start_rate(s, a, b, rest_length);
    case Step::StrainRate::start:
      return start_rate(s, a, b, rest_length);
    case Step::StrainRate::midpoint: {
      const Vec3 e = s.x[b] - s.x[a];
      const Vec3 dv = s.v[b] - s.v[a];
      const double l2 = e.squaredNorm();
      if (l2 == 0.0) return 0.0;
      const double across = dv.squaredNorm() - std::pow(e.dot(dv), 2) / l2;
      return 0.25 * step.h * across / (std::sqrt(l2) * rest_length);
    }
    case Step::StrainRate::predicted:
      return predicted_offset(step, a, b, rest_length);
    case Step::StrainRate::backward:
    case Step::StrainRate::none:
      return 0.0;
  }
  return 0.0;
}

}  // namespace

Stretching::Stretching(const Network& network) {
  elements_.reserve(network.segments.size());
  std::vector<Index> nodes;
  for (const Segment& s : network.segments) {
    const Material& m = network.materials[s.material];
    elements_.push_back(
        {s.a, s.b, s.rest_length, m.axial_stiffness, m.damping, m.compression, 0.0, 0.0});
    a_.push_back(s.a);
    b_.push_back(s.b);
    rest_.push_back(s.rest_length);
    stiffness_.push_back(m.axial_stiffness);
    bilateral_.push_back(m.compression ? 1.0 : 0.0);
    one_sided_ |= !m.compression;
    nodes.insert(nodes.end(), {s.a, s.b});
  }
  const std::size_t padded = elements_.size() + kernels::kElementPadding;
  a_.resize(padded, 0);
  b_.resize(padded, 0);
  rest_.resize(padded, 1.0);
  stiffness_.resize(padded, 1.0);
  bilateral_.resize(padded, 0.0);
  offset_.assign(padded, 0.0);
  foretold_.assign(padded, -1.0);
  awake_.assign(elements_.size(), 0);
  chunks_ = ElementChunks(nodes, 2);
}

void Stretching::couple(BlockPattern& pattern) const {
  for (const Element& e : elements_) pattern.couple(e.a, e.b);
}

void Stretching::bind(const BlockPattern& pattern) {
  slots_.clear();
  slots_.reserve(a_.size());
  for (const Element& e : elements_) slots_.push_back(pattern.slot(e.a, e.b));
  slots_.resize(a_.size(), 0);
}

void Stretching::prepare(const Step& step) {
  trapezoid_ = step.strain_rate == Step::StrainRate::trapezoid;
  const bool rated = step.strain_rate != Step::StrainRate::none;
  const bool linear = rated && step.strain_rate != Step::StrainRate::start;
  std::fill(foretold_.begin(), foretold_.end(), -1.0);
  std::fill(awake_.begin(), awake_.end(), 0);
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    Element& e = elements_[k];
    stiffness_[k] = e.axial_stiffness;
    offset_[k] = 0.0;
    e.viscous = 0.0;
    if (e.damping == 0.0 || !rated) continue;
    const double eps0 = axial_strain(step.start->x[e.a], step.start->x[e.b], e.rest_length);
    const bool taut = e.compression || eps0 > 0.0;
    e.strain = taut ? eps0 : 0.0;
    const double rate = linear ? step.rate : 0.0;
    double offset = taut ? rate_offset(step, e.a, e.b, e.rest_length) : 0.0;
    if (!e.compression && linear) offset = std::min(offset, rate * e.strain);
    stiffness_[k] = e.axial_stiffness * (1.0 + e.damping * rate);
    offset_[k] = e.axial_stiffness * e.damping * (rate * e.strain - offset);
    if (trapezoid_ && taut) {
      const double elastic = e.axial_stiffness * eps0;
      const double now = elastic + e.axial_stiffness * e.damping *
                                       start_rate(*step.start, e.a, e.b, e.rest_length);
      e.viscous = (e.compression ? now : std::max(0.0, now)) - elastic;
    }
  }
}

double Stretching::tension(std::size_t element, double strain) const {
  const bool compression = elements_[element].compression;
  if (!compression && strain <= 0.0) return 0.0;
  const double t = stiffness_[element] * strain - offset_[element];
  return compression ? t : std::max(0.0, t);
}

double Stretching::sum(const std::vector<Vec3>& y, bool definite,
                       const kernels::ElementSums& out) const {
  const kernels::SegmentArrays arrays{a_.data(),        b_.data(),         slots_.data(),
                                      rest_.data(),     stiffness_.data(), offset_.data(),
                                      foretold_.data(), bilateral_.data()};
  const kernels::ElementTable& table = kernels::elements();
  return chunks_.sum([&](long begin, long end) {
    return table.stretching(arrays, begin, end, y.front().data(), definite, out);
  });
}

double Stretching::potential(const Step&, const std::vector<Vec3>& y) const {
  return sum(y, false, {nullptr, nullptr, nullptr});
}

double Stretching::assemble(const Step&, const std::vector<Vec3>& y, Assembly& out) const {
  return sum(y, out.definite, element_sums(out));
}

// Gauss and Seidel's sweeps: every segment that is longer than at rest and at the start is
// shortened, its lighter node moving farther.
void Stretching::relax(const Step& step, const Weights& weights, std::vector<Vec3>& y) const {
  const std::vector<Vec3>& start = step.start->x;
  const std::vector<bool>& held = *weights.held;
  const std::vector<double>& mass = *weights.mass;
  bool moved = true;
  for (int sweep = 0; moved && sweep < kMostSweeps; ++sweep) {
    moved = false;
    for (const Element& e : elements_) {
      if (held[e.a] && held[e.b]) continue;
      const Vec3 apart = y[e.b] - y[e.a];
      const double square = apart.squaredNorm(), rest = (1.0 + kLeftStrain) * e.rest_length;
      if (square <= rest * rest) continue;
      const double before = (start[e.b] - start[e.a]).norm();
      const double longest = std::max(rest, (1.0 + kLeftStrain) * before);
      if (square <= longest * longest) continue;
      const double a = held[e.a] ? 0.0 : 1.0 / mass[e.a], b = held[e.b] ? 0.0 : 1.0 / mass[e.b];
      const Vec3 excess = (1.0 - longest / std::sqrt(square)) / (a + b) * apart;
      y[e.a] += a * excess;
      y[e.b] -= b * excess;
      moved = true;
    }
  }
}

// What is found here is of second order in the next way. Where a thread turns by a small angle its
// own tension is EA times the square of that angle, far more than what it carries at last, and a
// Hessian with that tension across the thread would hold back its next turn.
void Stretching::foretell(const std::vector<Vec3>& y, const std::vector<Vec3>& next) {
  if (!one_sided_) return;
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    const Element& e = elements_[k];
    if (e.compression) continue;
    const Vec3 apart = y[e.b] - y[e.a];
    const double length = apart.norm();
    const double strain = length / e.rest_length - 1.0;
    const double now = stiffness_[k] * strain - offset_[k];
    const bool counts = awake_[k] || std::min(strain, now) >= 0.0;
    awake_[k] = 0;
    foretold_[k] = 0.0;
    if (!counts || length == 0.0) continue;
    const double longer = apart.dot(next[e.b] - next[e.a] - apart) / length;
    foretold_[k] = std::max(0.0, now + stiffness_[k] / e.rest_length * longer);
  }
}

// Of the Hessian only what is along the segment and the tension given: the push that the segment
// would exert at y makes its own part across negative.
void Stretching::take_for_taut(std::size_t element, const std::vector<Vec3>& y, double strain,
                               double across, const Assembly& out) {
  const Element& e = elements_[element];
  const Vec3 apart = y[e.b] - y[e.a];
  const double length = apart.norm();
  const Vec3 t = apart / length;
  const Vec3 pull = (stiffness_[element] * strain - offset_[element]) * t;
  (*out.gradient)[e.b] += pull;
  (*out.gradient)[e.a] -= pull;
  const double turn = across / length, along = stiffness_[element] / e.rest_length - turn;
  const Mat3 block = along * t * t.transpose() + turn * Mat3::Identity();
  out.hessian->diagonal[e.a] += block;
  out.hessian->diagonal[e.b] += block;
  out.hessian->below[slots_[element]] -= block;
  awake_[element] = 1;
}

bool Stretching::hold(const std::vector<Vec3>& y, const Assembly& out) {
  bool any = false;
  std::fill(awake_.begin(), awake_.end(), 0);
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    const Element& e = elements_[k];
    if (!(foretold_[k] > 0.0)) continue;
    const double strain = axial_strain(y[e.a], y[e.b], e.rest_length);
    if (strain < -kHeldSlack || tension(k, strain) > 0.0) continue;
    take_for_taut(k, y, strain, foretold_[k], out);
    any = true;
  }
  return any;
}

double Stretching::awaken(const std::vector<Vec3>& y, const std::vector<Vec3>& next,
                          const Assembly* out) {
  double sum = 0.0;
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    const Element& e = elements_[k];
    if (e.compression || awake_[k]) continue;
    const double then = tension(k, axial_strain(next[e.a], next[e.b], e.rest_length));
    const double strain = axial_strain(y[e.a], y[e.b], e.rest_length);
    if (then == 0.0 || strain == -1.0 || tension(k, strain) > 0.0) continue;
    sum += 0.5 * then * then * e.rest_length / stiffness_[k];
    if (out) take_for_taut(k, y, strain, 0.0, *out);
  }
  return sum;
}

// By the mean rate of the taut strain over the step, N; the tension is never a push where threads
// cannot be compressed.
double Stretching::mean_viscous(const Element& e, double end, double h) {
  const double viscous = e.axial_stiffness * e.damping * (end - e.strain) / h;
  const double elastic = 0.5 * e.axial_stiffness * (end + e.strain);
  return e.compression ? viscous : std::max(viscous, -elastic);
}

// Viscous tension times elongation. The trapezoid's force over the step is the mean of those at its
// two ends.
void Stretching::account(const Step& step, const std::vector<Vec3>& y, const std::vector<Vec3>& x1,
                         Exchange& exchange) const {
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    const Element& e = elements_[k];
    if (e.damping == 0.0) continue;
    const double stage = axial_strain(y[e.a], y[e.b], e.rest_length);
    const double end = axial_strain(x1[e.a], x1[e.b], e.rest_length);
    const double taut_stage = e.compression ? stage : std::max(0.0, stage);
    const double taut_end = e.compression ? end : std::max(0.0, end);
    double viscous = tension(k, stage) - e.axial_stiffness * taut_stage;
    if (trapezoid_) viscous = 0.5 * (viscous + e.viscous);
    if (step.remembers()) viscous = mean_viscous(e, taut_end, step.h);
    exchange.material_loss += viscous * e.rest_length * (taut_end - e.strain);
  }
}

std::vector<double> Stretching::tensions(const std::vector<Vec3>& y) const {
  std::vector<double> result;
  tensions(y, result);
  return result;
}

void Stretching::tensions(const std::vector<Vec3>& y, std::vector<double>& result) const {
  result.resize(elements_.size());
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    const Element& e = elements_[k];
    result[k] = tension(k, axial_strain(y[e.a], y[e.b], e.rest_length));
  }
}

double Stretching::energy(const std::vector<Vec3>& x) const {
  double sum = 0.0;
  for (const Element& e : elements_) {
    double eps = axial_strain(x[e.a], x[e.b], e.rest_length);
    if (!e.compression) eps = std::max(0.0, eps);
    sum += 0.5 * e.axial_stiffness * e.rest_length * eps * eps;
  }
  return sum;
}

}  // namespace retiarius
