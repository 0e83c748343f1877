#include "retiarius/forces/stretching.hpp"

#include <algorithm>
#include <cmath>

namespace retiarius {

namespace {

// Strain below which a tension-only thread is slack beyond doubt: above what rounding makes of the
// rest length.
constexpr double kEdge = 1e-12;

// Rate of the strain at the start of the step, from the start's velocities, 1/s.
double start_rate(const State& s, Index a, Index b, double rest_length) {
  const Vec3 e = s.x[b] - s.x[a];
  const double l = e.norm();
  return l > 0.0 ? e.dot(s.v[b] - s.v[a]) / (l * rest_length) : 0.0;
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
    case Step::StrainRate::backward:
    case Step::StrainRate::none:
      return 0.0;
  }
  return 0.0;
}

}  // namespace

Stretching::Stretching(const Network& network) {
  elements_.reserve(network.segments.size());
  for (const Segment& s : network.segments) {
    const Material& m = network.materials[s.material];
    elements_.push_back({s.a, s.b, s.rest_length, m.axial_stiffness, m.damping, m.compression,
                         m.axial_stiffness, 0.0, 0.0, 0.0});
  }
}

void Stretching::couple(BlockPattern& pattern) const {
  for (const Element& e : elements_) pattern.couple(e.a, e.b);
}

void Stretching::bind(const BlockPattern& pattern) {
  slots_.clear();
  slots_.reserve(elements_.size());
  for (const Element& e : elements_) slots_.push_back(pattern.slot(e.a, e.b));
}

void Stretching::prepare(const Step& step) {
  trapezoid_ = step.strain_rate == Step::StrainRate::trapezoid;
  const bool rated = step.strain_rate != Step::StrainRate::none;
  const bool linear = rated && step.strain_rate != Step::StrainRate::start;
  for (Element& e : elements_) {
    e.stiffness = e.axial_stiffness;
    e.offset = 0.0;
    e.viscous = 0.0;
    if (e.damping == 0.0 || !rated) continue;
    const double eps0 = axial_strain(step.start->x[e.a], step.start->x[e.b], e.rest_length);
    const bool taut = e.compression || eps0 > 0.0;
    e.strain = taut ? eps0 : 0.0;
    const double rate = linear ? step.rate : 0.0;
    double offset = taut ? rate_offset(step, e.a, e.b, e.rest_length) : 0.0;
    if (!e.compression && linear) offset = std::min(offset, rate * e.strain);
    e.stiffness = e.axial_stiffness * (1.0 + e.damping * rate);
    e.offset = e.axial_stiffness * e.damping * (rate * e.strain - offset);
    if (trapezoid_ && taut) {
      const double elastic = e.axial_stiffness * eps0;
      const double now = elastic + e.axial_stiffness * e.damping *
                                       start_rate(*step.start, e.a, e.b, e.rest_length);
      e.viscous = (e.compression ? now : std::max(0.0, now)) - elastic;
    }
  }
}

double Stretching::tension(const Element& e, double strain) const {
  if (!e.compression && strain <= 0.0) return 0.0;
  const double t = e.stiffness * strain - e.offset;
  return e.compression ? t : std::max(0.0, t);
}

double Stretching::potential(const Step&, const std::vector<Vec3>& y) const {
  double sum = 0.0;
  for (const Element& e : elements_) {
    const double eps = axial_strain(y[e.a], y[e.b], e.rest_length);
    if (e.compression) {
      sum += e.rest_length * eps * (0.5 * e.stiffness * eps - e.offset);
    } else {
      const double t = tension(e, eps);
      sum += 0.5 * e.rest_length * t * t / e.stiffness;
    }
  }
  return sum;
}

void Stretching::assemble(const Step&, const std::vector<Vec3>& y, Assembly& out) const {
  std::vector<Vec3>& g = *out.gradient;
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    const Element& e = elements_[k];
    const Vec3 edge = y[e.b] - y[e.a];
    const double l = edge.norm();
    const double strain = l / e.rest_length - 1.0;
    const double t = tension(e, strain);
    // A thread at the edge of slackness counts as taut in the Hessian: straight threads at rest
    // would else learn of a pull by one segment an iteration.
    if (!e.compression && std::min(strain, strain - e.offset / e.stiffness) < -kEdge) continue;
    // A bilateral segment of no length has no direction; any one will do for the push apart.
    const Vec3 dir = l > 0.0 ? Vec3(edge / l) : Vec3::UnitX();
    const Vec3 force = t * dir;
    g[e.a] -= force;
    g[e.b] += force;
    if (!out.hessian) continue;
    const double across = (out.definite ? std::max(0.0, t) : t) / std::max(l, 1e-9 * e.rest_length);
    Mat3 block = ((e.stiffness / e.rest_length - across) * dir) * dir.transpose();
    block.diagonal().array() += across;
    out.hessian->diagonal[e.a] += block;
    out.hessian->diagonal[e.b] += block;
    out.hessian->below[slots_[k]] -= block;
  }
}

// Viscous tension times elongation. The trapezoid's force over the step is the mean of those at its
// two ends.
void Stretching::account(const Step&, const std::vector<Vec3>& y, const std::vector<Vec3>& x1,
                         Exchange& exchange) const {
  for (const Element& e : elements_) {
    if (e.damping == 0.0) continue;
    const double stage = axial_strain(y[e.a], y[e.b], e.rest_length);
    const double end = axial_strain(x1[e.a], x1[e.b], e.rest_length);
    const double taut_stage = e.compression ? stage : std::max(0.0, stage);
    const double taut_end = e.compression ? end : std::max(0.0, end);
    double viscous = tension(e, stage) - e.axial_stiffness * taut_stage;
    if (trapezoid_) viscous = 0.5 * (viscous + e.viscous);
    exchange.material_loss += viscous * e.rest_length * (taut_end - e.strain);
  }
}

std::vector<double> Stretching::tensions(const std::vector<Vec3>& y) const {
  std::vector<double> result;
  result.reserve(elements_.size());
  for (const Element& e : elements_)
    result.push_back(tension(e, axial_strain(y[e.a], y[e.b], e.rest_length)));
  return result;
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
