// Where a step with barriers starts its iteration: as near to the first guess as is free.
#include <algorithm>

#include "retiarius/base/stopwatch.hpp"
#include "retiarius/motion/step_problem.hpp"

namespace retiarius {

namespace {

// Rounds in which nodes that are hindered on their way to the first guess are put elsewhere.
constexpr int kMostRounds = 8;

}  // namespace

// Bodies start where their free motion leads, nodes at the guess where nothing is in their way.
// What would run into a body is carried along by it instead, threads that would run into each other
// move together, and their neighbours follow as far as the segments between them reach. Where that
// does not help, everything goes only as far as all of it is free.
void StepProblem::free_guess() {
  const Stopwatch all(times_.assembly), watch(times_.contact);
  const Step& step = *start_.step;
  const State& start = *step.start;
  End& from = other_end_;
  from.nodes = start.x;
  from.bodies = start.bodies;
  from.turns.assign(start.bodies.size(), Vec3::Zero());
  double share = 1.0;
  for (int round = 0; round < kMostRounds; ++round) {
    find_end(end_);
    share = start_.barrier->look_ahead(from.places(), end_.places());
    if (share >= 1.0) return;
    std::vector<Vec3>& end = end_.nodes;
    hold_together(end);
    hold_at_bodies(end);
    relax(end);
    for (std::size_t i = 0; i < y_.size(); ++i)
      if (constraint_of_[i] == kNone) y_[i] = start.x[i] + (end[i] - start.x[i]) / step.reach;
  }
  find_end(end_);
  share = start_.barrier->look_ahead(from.places(), end_.places());
  if (share >= 1.0) return;
  for (std::size_t i = 0; i < y_.size(); ++i) y_[i] = start.x[i] + share * (y_[i] - start.x[i]);
  for (std::size_t b = 0; b < b_.size(); ++b) {
    if ((*bodies_)[b].fixed) continue;
    const BodyTwist way = motion_between(start.bodies[b], end_.bodies[b]);
    const BodyState reached =
        displaced(start.bodies[b], share * way.translation, share * way.rotation);
    const BodyTwist back = motion_between(start_.bodies[b], reached);
    b_[b] << back.translation, back.rotation;
    b_[b] /= step.reach;
  }
  project_guess();
  find_end(end_);
  start_.barrier->look_ahead(from.places(), end_.places());
}

// Threads that would meet get the mean of their nodes' motions, or that of what is held of them.
void StepProblem::hold_together(std::vector<Vec3>& end) {
  const std::vector<Vec3>& start = start_.step->start->x;
  std::vector<Vec3>& sum = way_sum_;
  std::vector<int>& count = way_count_;
  sum.assign(end.size(), Vec3::Zero());
  count.assign(end.size(), 0);
  for (const ContactPair& pair : start_.barrier->blocked()) {
    if (!is_of_threads(pair)) continue;
    const std::array<PointPlace, 4> places = start_.barrier->scene().places(pair);
    Vec3 of_held = Vec3::Zero(), of_all = Vec3::Zero();
    double held = 0.0, mass = 0.0;
    for (int i = 0; i < point_count(pair.kind); ++i) {
      const Index n = places[i].point;
      const Vec3 move = end[n] - start[n];
      of_all += mass_[n] * move;
      mass += mass_[n];
      if (!held_[n]) continue;
      of_held += move;
      held += 1.0;
    }
    const Vec3 move = held > 0.0 ? Vec3(of_held / held) : Vec3(of_all / mass);
    for (int i = 0; i < point_count(pair.kind); ++i) {
      sum[places[i].point] += move;
      ++count[places[i].point];
    }
  }
  for (std::size_t i = 0; i < end.size(); ++i)
    if (count[i] > 0 && !held_[i]) end[i] = start[i] + sum[i] / count[i];
}

// Nodes that would run into a body are carried along by it.
void StepProblem::hold_at_bodies(std::vector<Vec3>& end) {
  const State& start = *start_.step->start;
  for (const ContactPair& pair : start_.barrier->blocked()) {
    if (is_of_threads(pair)) continue;
    const std::array<PointPlace, 4> places = start_.barrier->scene().places(pair);
    const Index body = pair.first_owner == kNet ? pair.second_owner : pair.first_owner;
    for (int i = 0; i < point_count(pair.kind); ++i) {
      if (places[i].owner != kNet || held_[places[i].point]) continue;
      const Index n = places[i].point;
      end[n] = to_world(end_.bodies[body], to_body(start.bodies[body], start.x[n]));
      held_[n] = true;
    }
  }
}

}  // namespace retiarius
