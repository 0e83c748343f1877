#include "retiarius/contact/barrier.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/base/parallel.hpp"
#include "retiarius/base/stopwatch.hpp"
#include "retiarius/contact/advance.hpp"
#include "retiarius/contact/barrier_function.hpp"

namespace retiarius {

namespace {

// Of the stiffness, see the class: the strain that is carried within the range. At 1e-3 what enters
// the range on a Newton step meets a wall, at which the line search stops for each pair anew; below
// 1e-5 nothing more is gained.
constexpr double kCarriedStrain = 1e-5;

// How far anything may move before pairs are looked for anew, over the barrier's range.
constexpr double kSlack = 4.0;

// How far segments may leave the ways that were searched for pairs of threads before it is done
// anew for them, over the barrier's range.
constexpr double kThreadSlack = 2.0;

// How far beyond the barrier's range threads are coupled beforehand, over the sum of their radii.
// Twice as far makes the factorisation of a capture dearer by a fourth, half as far needs the
// pattern analysed more often.
constexpr double kReach = 0.5;

// Of a gap: what a way may take of it so that it need not be looked along in detail. Less than the
// share that advance() allows, with room for rounding.
constexpr double kSafeShare = 0.85;

// Of the ways of bodies, for what their attitudes between two ends differ from a constant twist.
constexpr double kTwistRoom = 1.05;

// The usual range of the barrier, over the radius of the thinnest thread.
constexpr double kUsualGap = 0.25;

// The thinnest and the thickest thread's, m.
std::pair<double, double> radii(const Network& network) {
  double least = kInfinity, most = 0.0;
  for (const Segment& s : network.segments) {
    const double r = network.materials[s.material].radius;
    least = std::min(least, r);
    most = std::max(most, r);
  }
  return {least, most};
}

}  // namespace

BarrierContact::BarrierContact(const Network& network, const std::vector<Body>& bodies,
                               const ContactSpec& spec, double step)
    : network_(&network),
      bodies_(&bodies),
      spec_(spec),
      step_size_(step),
      range_(spec.gap > 0.0 ? spec.gap : kUsualGap * radii(network).first),
      slack_(kSlack * range_),
      scene_(make_collision_scene(network, bodies)) {
  if (spec.self) neighbours_.emplace(network);
  BroadPhase::Options options;
  options.self = spec.self;
  for (const Body& b : bodies) options.fixed.push_back(b.fixed);
  options.slack = kThreadSlack * range_;
  options.reach = 2.0 * kReach * radii(network).second;
  broad_.emplace(scene_, neighbours_ ? &*neighbours_ : nullptr, std::move(options));
  for (const Material& m : network.materials)
    axial_stiffness_ = std::max(axial_stiffness_, m.axial_stiffness);
  body_places_.resize(bodies.size());
}

// Of what the primitive's points belong to; infinite for what does not move.
double BarrierContact::mass_of(Index owner, const PointPlace* places, int count) const {
  if (owner != kNet) {
    const Body& body = (*bodies_)[static_cast<std::size_t>(owner)];
    return body.fixed ? kInfinity : body.mass;
  }
  double sum = 0.0;
  for (int i = 0; i < count; ++i) sum += network_->mass[places[i].point];
  return sum;
}

double BarrierContact::stiffness(const ContactPair& pair,
                                 const std::array<PointPlace, 4>& places) const {
  const int first = first_count(pair.kind);
  const double a = mass_of(pair.first_owner, places.data(), first);
  const double b =
      mass_of(pair.second_owner, places.data() + first, point_count(pair.kind) - first);
  const double reduced = 1.0 / (1.0 / a + 1.0 / b);
  return reduced / (step_size_ * step_size_) + kCarriedStrain * axial_stiffness_ / range_;
}

std::string BarrierContact::name(const ContactPair& pair) const {
  const auto primitive = [&](Index owner, Index index, bool edge, const char* of_body) {
    if (owner == kNet) {
      if (!edge) return fmt::format("node {}", index);
      const Segment& s = network_->segments[static_cast<std::size_t>(index)];
      return fmt::format("segment {} (nodes {} and {})", index, s.a, s.b);
    }
    return fmt::format("{} {} of {}", of_body, index,
                       (*bodies_)[static_cast<std::size_t>(owner)].name);
  };
  const bool edge = pair.kind == PairKind::edge_edge;
  const char* second = pair.kind == PairKind::point_point      ? "point"
                       : pair.kind == PairKind::point_triangle ? "triangle"
                       : pair.kind == PairKind::point_plane    ? "plane"
                                                               : "edge";
  // A sphere's point stands first against a segment.
  return fmt::format(
      "{} and {}", primitive(pair.first_owner, pair.first, edge, edge ? "edge" : "point"),
      primitive(pair.second_owner, pair.second, edge || pair.kind == PairKind::point_edge, second));
}

void BarrierContact::begin(const Step& step, double& search_time) {
  step_ = &step;
  search_time_ = &search_time;
  searched_ = false;
  const State& start = *step.start;
  no_turns_.assign(start.bodies.size(), Vec3::Zero());
  const ContactPlaces at{&start.x, &start.bodies, &no_turns_};
  foretold_.clear();
  const std::vector<ContactPair>& pairs = search(at, at);
  mark_near(at);
  for (const std::size_t k : near_) {
    if (gaps_[k] > 0.0) {
      foretold_.push_back({pairs[k], -barrier(gaps_[k], range_).first});
      continue;
    }
    throw RunError(fmt::format(
        "barrier contact starts at time {:.9g} s from a state that interpenetrates: {} by {:.3g} "
        "m; move them apart, or take contact.method = \"modified-mass\"",
        start.time, name(pairs[k]), -gaps_[k]));
  }
  slidings(at, false, sliding_);
  rounds_ = 1;
  foretold_rounds_ = 0;
}

// Whether nothing is farther than the slack from where it was when pairs were looked for last.
bool BarrierContact::is_near_searched(const ContactPlaces& at) const {
  for (std::size_t i = 0; i < searched_nodes_.size(); ++i)
    if (!(((*at.nodes)[i] - searched_nodes_[i]).squaredNorm() <= slack_ * slack_)) return false;
  for (std::size_t b = 0; b < searched_bodies_.size(); ++b) {
    const BodyTwist way = motion_between(searched_bodies_[b], (*at.bodies)[b]);
    const double turn = way.rotation.norm();
    const double reach = turn > 0.0 ? turn * scene_.bodies[b].bounding_radius : 0.0;
    if (!(way.translation.norm() + reach <= slack_)) return false;
  }
  return true;
}

// With the range as margin, so that what is in contact on the way is among the pairs found. For
// short ways, as an iteration ends with, all within the slack of one place are found at once.
const std::vector<ContactPair>& BarrierContact::search(const ContactPlaces& from,
                                                       const ContactPlaces& to) {
  const Stopwatch watch(*search_time_);
  const std::size_t n = from.nodes->size();
  moves_.resize(n);
  for (std::size_t i = 0; i < n; ++i) moves_[i] = (*to.nodes)[i] - (*from.nodes)[i];
  twists_.clear();
  for (std::size_t b = 0; b < from.bodies->size(); ++b)
    twists_.push_back(motion_between((*from.bodies)[b], (*to.bodies)[b]));
  if (searched_ && is_near_searched(from) && is_near_searched(to)) return broad_->pairs();
  searched_nodes_ = *from.nodes;
  searched_bodies_ = *from.bodies;
  searched_ = is_near_searched(to);
  if (!searched_) {
    broad_->find(*from.nodes, moves_, twists_, range_);
  } else {
    resting_.assign(n, Vec3::Zero());
    resting_bodies_.clear();
    for (const BodyState& pose : *from.bodies) resting_bodies_.push_back(at_rest(pose));
    broad_->find(*from.nodes, resting_, resting_bodies_, range_ + 2.0 * slack_);
  }
  keep_gaps();
  return broad_->pairs();
}

// Of pairs that were candidates before, too, the gaps at the place last evaluated stay known.
void BarrierContact::keep_gaps() {
  const std::vector<Index>& before = broad_->before();
  kept_gaps_.resize(before.size());
  for (std::size_t k = 0; k < before.size(); ++k)
    kept_gaps_[k] = before[k] == kNone ? -kInfinity : gaps_[static_cast<std::size_t>(before[k])];
  gaps_.swap(kept_gaps_);
  floors_.clear();
  near_is_known_ = false;
}

bool BarrierContact::is_last_evaluated(const ContactPlaces& at) const {
  const auto same = [](const BodyState& a, const BodyState& b) {
    return a.position == b.position && a.attitude.coeffs() == b.attitude.coeffs();
  };
  return evaluated_nodes_ == *at.nodes &&
         std::equal(at.bodies->begin(), at.bodies->end(), evaluated_bodies_.begin(),
                    evaluated_bodies_.end(), same);
}

// How far nodes and points of bodies get from where they start on the way last searched.
void BarrierContact::bound_ways() {
  node_ways_.resize(moves_.size());
  for (std::size_t i = 0; i < moves_.size(); ++i) node_ways_[i] = moves_[i].norm();
  body_ways_.resize(twists_.size());
  for (std::size_t b = 0; b < twists_.size(); ++b) {
    const double turn = twists_[b].rotation.norm();
    const double round = turn > 0.0 ? turn * scene_.bodies[b].bounding_radius : 0.0;
    body_ways_[b] = kTwistRoom * (twists_[b].translation.norm() + round);
  }
}

// By how much the pair's gap may shrink on the way last searched. A plane that turns goes any way.
double BarrierContact::way(const ContactPair& pair) const {
  if (pair.kind == PairKind::point_plane) return kInfinity;
  const std::array<PointPlace, 4> places = scene_.places(pair);
  const int first = first_count(pair.kind), count = point_count(pair.kind);
  double side[2] = {0.0, 0.0};
  for (int i = 0; i < count; ++i) {
    const auto [owner, point] = places[i];
    const double one = owner == kNet ? node_ways_[static_cast<std::size_t>(point)]
                                     : body_ways_[static_cast<std::size_t>(owner)];
    side[i < first ? 0 : 1] = std::max(side[i < first ? 0 : 1], one);
  }
  return side[0] + side[1];
}

double BarrierContact::gap(const ContactPair& pair, const ContactPlaces& at) const {
  return distance(pair.kind, scene_.positions(pair, *at.nodes, *at.bodies)).value -
         scene_.thickness(pair);
}

double BarrierContact::look_ahead(const ContactPlaces& from, const ContactPlaces& to) {
  const std::vector<ContactPair>& pairs = search(from, to);
  bound_ways();
  const bool known = is_last_evaluated(from);
  shares_.resize(pairs.size());
  floors_.resize(pairs.size());
  parallel_for(pairs.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const double reach = way(pairs[k]);
      double least = known ? gaps_[k] : -kInfinity;
      if (!(reach <= kSafeShare * least)) {
        least = gap(pairs[k], from);
        if (known) gaps_[k] = least;
      }
      floors_[k] = least - reach;
      shares_[k] = 1.0;
      if (reach <= kSafeShare * least) continue;
      const PairMotion motion = scene_.motion(pairs[k], *from.nodes, moves_, twists_);
      shares_[k] = advance(motion, scene_.thickness(pairs[k]));
    }
  });
  blocked_.clear();
  double share = 1.0;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (shares_[k] >= 1.0) continue;
    share = std::min(share, shares_[k]);
    blocked_.push_back(pairs[k]);
  }
  return share;
}

bool BarrierContact::motion_is_free(const ContactPlaces& start, const ContactPlaces& end,
                                    std::string& pair_name) {
  const std::vector<ContactPair>& pairs = search(start, end);
  bound_ways();
  shares_.resize(pairs.size());
  parallel_for(pairs.size(), kGrain, [&](std::size_t begin, std::size_t stop) {
    for (std::size_t k = begin; k < stop; ++k) {
      const double thickness = scene_.thickness(pairs[k]), most = kMotionShare * thickness;
      shares_[k] = 1.0;
      if (way(pairs[k]) <= kSafeShare * (gap(pairs[k], start) + thickness - most)) continue;
      const PairMotion motion = scene_.motion(pairs[k], *start.nodes, moves_, twists_);
      shares_[k] = advance(motion, most, 1e-3);
    }
  });
  const auto blocked =
      std::find_if(shares_.begin(), shares_.end(), [](double share) { return share < 1.0; });
  if (blocked == shares_.end()) return true;
  pair_name = name(pairs[static_cast<std::size_t>(blocked - shares_.begin())]);
  return false;
}

std::vector<std::pair<Index, Index>> BarrierContact::couplings(const ContactPlaces& at,
                                                               Coupled which) {
  mark_near(at);
  std::vector<std::pair<Index, Index>> result;
  const auto couple = [&](const ContactPair& pair) {
    const std::array<PointPlace, 4> places = scene_.places(pair);
    for (int i = 0; i < 2; ++i)
      for (int j = 2; j < 4; ++j)
        result.emplace_back(std::minmax(places[i].point, places[j].point));
  };
  const std::vector<ContactPair>& pairs = broad_->pairs();
  if (which == Coupled::in_range) {
    for (const std::size_t k : near_)
      if (is_of_threads(pairs[k])) couple(pairs[k]);
  } else {
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      if (!is_of_threads(pairs[k])) continue;
      const double reach = range_ + kReach * scene_.thickness(pairs[k]);
      if (gaps_[k] < reach && gap(pairs[k], at) < reach) couple(pairs[k]);
    }
  }
  // Friction acts for the whole round, however far the two have parted since.
  for (const Sliding& s : sliding_)
    if (is_of_threads(s.pair)) couple(s.pair);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace retiarius
