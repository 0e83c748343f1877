// Friction of barrier contact, and what its contacts did.
#include <algorithm>
#include <cmath>

#include "retiarius/contact/barrier.hpp"
#include "retiarius/contact/barrier_function.hpp"

namespace retiarius {

// Of the pair's materials: a body's own coefficient counts before the mission's.
double BarrierContact::coefficient(const ContactPair& pair) const {
  const auto of_body = [&](Index owner) {
    return (*bodies_)[static_cast<std::size_t>(owner)].friction.value_or(spec_.friction);
  };
  if (is_of_threads(pair)) return spec_.thread_friction;
  if (pair.first_owner == kNet) return of_body(pair.second_owner);
  if (pair.second_owner == kNet) return of_body(pair.first_owner);
  return 0.5 * (of_body(pair.first_owner) + of_body(pair.second_owner));
}

// The contacts at a place with their normal forces, or those foretold where that is wanted.
void BarrierContact::slidings(const ContactPlaces& at, bool foretold_forces,
                              std::vector<Sliding>& result) {
  result.clear();
  const State& start = *step_->start;
  Near near;
  mark_near(at);
  for (const std::size_t k : near_) {
    const ContactPair& pair = broad_->pairs()[k];
    if (coefficient(pair) == 0.0 || !is_near(pair, at, false, near)) continue;
    Sliding s;
    s.pair = pair;
    s.places = near.places;
    s.count = point_count(pair.kind);
    s.weight = near.distance.weight;
    s.normal = near.distance.normal;
    const Foretold* known = foretold_forces ? foretold(pair) : nullptr;
    s.force = known ? near.weight.value * near.stiffness * known->push : near.force;
    s.start = scene_.positions(pair, start.x, start.bodies);
    result.push_back(s);
  }
}

// The tangential displacement of the first against the second primitive over the step, m.
Vec3 BarrierContact::slip(const Sliding& s, const ContactPlaces& at) const {
  Vec3 u = Vec3::Zero();
  for (int i = 0; i < s.count; ++i) u += s.weight[i] * (world(s.places[i], at) - s.start[i]);
  return u - s.normal * s.normal.dot(u);
}

void BarrierContact::friction_term(const Sliding& s, const ContactPlaces& at,
                                   const ContactAssembly* out, Term& term) const {
  const double limit = coefficient(s.pair) * s.force;
  const Vec3 u = slip(s, at);
  const double size = u.norm();
  const SlipJet f = smooth_slip(size, spec_.stick_speed * step_->h);
  term.places = s.places;
  term.count = out && limit > 0.0 ? s.count : 0;
  term.energy = limit * f.value;
  term.round_off = 0.0;
  if (term.count == 0) return;
  const Vec3 pull = limit * f.over * u;
  term.gradient.setZero();
  for (int i = 0; i < s.count; ++i) term.gradient.segment<3>(3L * i) = s.weight[i] * pull;
  if (!out->hessian) return;
  Mat3 h = f.over * (Mat3::Identity() - s.normal * s.normal.transpose());
  if (size > 0.0)
    h += share_of_newton(s.before, u) * (f.second - f.over) / (size * size) * u * u.transpose();
  term.hessian.setZero();
  for (int i = 0; i < s.count; ++i)
    for (int j = 0; j < s.count; ++j)
      term.hessian.block<3, 3>(3L * i, 3L * j) = (limit * s.weight[i] * s.weight[j]) * h;
}

bool BarrierContact::revise(const ContactPlaces& at, bool solved) {
  int& rounds = solved ? rounds_ : foretold_rounds_;
  if (rounds >= spec_.friction_rounds) return false;
  std::vector<Sliding>& next = next_sliding_;
  slidings(at, !solved, next);
  // Both are ordered as the pairs are.
  double change = 0.0, sum = 1e-300;
  auto old = sliding_.begin();
  for (const Sliding& s : next) {
    for (; old != sliding_.end() && old->pair < s.pair; ++old) change += old->force;
    sum += s.force;
    if (old != sliding_.end() && old->pair == s.pair) {
      change += (s.force * s.normal - old->force * old->normal).norm();
      ++old;
    } else {
      change += s.force;
    }
  }
  for (; old != sliding_.end(); ++old) change += old->force;
  if (change <= spec_.friction_tolerance * sum) return false;
  ++rounds;
  sliding_.swap(next);
  return true;
}

void BarrierContact::contacts(const ContactPlaces& at, std::vector<PairContact>& result) {
  place_bodies(at);
  result.clear();
  Near near;
  mark_near(at);
  for (const std::size_t k : near_) {
    const ContactPair& pair = broad_->pairs()[k];
    if (!is_near(pair, at, true, near)) continue;
    PairContact c;
    c.pair = pair;
    c.places = near.places;
    c.place = near.p;
    c.weight = near.distance.weight;
    c.normal = near.distance.normal;
    c.gap = near.gap;
    c.force = near.force;
    c.energy = near.energy;
    for (int i = 0; i < 4; ++i) c.point_force[i] = -near.gradient.segment<3>(3L * i);
    const int first = first_count(pair.kind);
    for (int i = 0; i < first; ++i) c.point += near.distance.weight[i] * near.p[i];
    c.point -= near.distance.value * near.distance.normal;
    result.push_back(c);
  }
  for (const Sliding& s : sliding_) add_friction_to(result, s, at);
}

// To the contact of the same pair, which may have parted since friction was determined.
void BarrierContact::add_friction_to(std::vector<PairContact>& contacts, const Sliding& s,
                                     const ContactPlaces& at) const {
  auto found =
      std::lower_bound(contacts.begin(), contacts.end(), s.pair,
                       [](const PairContact& c, const ContactPair& p) { return c.pair < p; });
  if (found == contacts.end() || found->pair != s.pair) {
    PairContact parted;
    parted.pair = s.pair;
    parted.places = s.places;
    for (int i = 0; i < s.count; ++i) parted.place[i] = world(s.places[i], at);
    parted.weight = s.weight;
    parted.normal = s.normal;
    parted.gap = range_;
    parted.point_force.fill(Vec3::Zero());
    for (int i = 0; i < first_count(s.pair.kind); ++i)
      parted.point += s.weight[i] * world(s.places[i], at);
    found = contacts.insert(found, parted);
  }
  const double limit = coefficient(s.pair) * s.force;
  found->slip = slip(s, at);
  found->friction =
      -limit * smooth_slip(found->slip.norm(), spec_.stick_speed * step_->h).over * found->slip;
  for (int i = 0; i < s.count; ++i) found->point_force[i] += s.weight[i] * found->friction;
}

}  // namespace retiarius
