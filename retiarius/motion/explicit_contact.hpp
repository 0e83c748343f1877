// Contact of nodes with rigid bodies within the sub-steps of the explicit integrator.
#pragma once

#include <vector>

#include "retiarius/base/line_vector.hpp"
#include "retiarius/bodies/body.hpp"
#include "retiarius/motion/surface_planes.hpp"
#include "retiarius/motion/sweep_layout.hpp"
#include "retiarius/state/state.hpp"

namespace retiarius {

// After the laws have moved the nodes over a sub-step, a node that would end below the thread's
// radius from a surface gets the impulse that ends it there (plastic impact, the modified mass
// method's constraint). Friction brings it back to the place where it stuck, by a tangential
// impulse of at most the friction coefficient times the normal one; beyond that it slides. Free
// bodies take the opposite impulses at once, and the contacts of one sub-step take turns until none
// changes.
//
// Cost: each node has a box within which it cannot touch, since distances change by no more than
// the ways of node and body; only nodes outside their box are looked at, once the way of the
// fastest lets any be there. Near a surface, the plane at the last query serves for a hundredth of
// the thread's radius r: the surface at distance r is nowhere bent more than 1 / r, so the plane is
// wrong by less than r / 20,000 there. Where the query found a gap, it serves for nine tenths of
// that: neither the surface nor the plane can be met there.
class ExplicitContact {
 public:
  // radius: of the thread at each node, m.
  ExplicitContact(const std::vector<Body>& bodies, std::vector<double> radius, double friction);

  // Where the nodes' motion is kept.
  struct Nodes {
    const SweepLayout* layout = nullptr;
    double* x = nullptr;
    double* v = nullptr;
    const std::vector<double>* mass = nullptr;
    const std::vector<char>* held = nullptr;  // that prescribed motion takes out of contact
  };
  // What the contacts of one sub-step gave to the net.
  struct Given {
    Vec3 impulse = Vec3::Zero();  // N s
    Vec3 shift = Vec3::Zero();    // sum of m dx that no velocity accounts for, kg m
  };

  // Starts sub-steps of length h from a state.
  void begin(const Nodes& nodes, const State& start, double h);

  // One sub-step, after the laws gave the nodes their velocities (by a kick of length `kick`) and
  // places: moves the bodies under `gravity` and sees to the contacts. way: no coordinate of a node
  // that contacts leave alone has changed by more in this sub-step, m.
  Given step(const Vec3& gravity, double kick, double way, Account& account);

  // After the half kick that ends the last sub-step: velocities into a surface are stopped, of all
  // nodes that have reached one.
  void finish(const Vec3& gravity, double kick, Account& account);

  // The bodies, and the touches with the mean reactions over time h (s), ordered by node. Bodies
  // that nothing touched are left as they are in `bodies`.
  void end(double h, std::vector<BodyState>& bodies, std::vector<Touch>& touches) const;

  // Times since begin() that the contacts of a sub-step did not settle within the turns allowed.
  int unsettled() const { return unsettled_; }

 private:
  // Shares of the thread's radius: within which gap a node is watched at every sub-step, and beyond
  // which it is let go.
  static constexpr double kNear = 0.5;
  static constexpr double kFar = 1.0;

  // What each sub-step needs of a contact comes first, in few cache lines.
  struct Contact {
    Index node = kNone, body = kNone;
    SweepLayout::Slot slot;  // of the node
    double mass = 0.0, radius = 0.0;
    // The query that stands for the surface; in body axes, of a fixed body in world axes.
    Vec3 origin = Vec3::Zero();
    double reach = 0.0;  // distance from there within which it serves, squared, m2
    Vec3 normal = Vec3::UnitZ();
    double distance = 0.0;
    double gap = 0.0;  // at the end of the last sub-step, m
    bool sticks = false, pushed = false;
    Vec3 place = Vec3::Zero();     // of the node at the end of the last sub-step, body axes
    Vec3 anchor = Vec3::Zero();    // where it sticks, body axes
    Vec3 relative = Vec3::Zero();  // velocity at the end of the last sub-step
    // World axes; kept through the turns of a sub-step, so that a turn can take back an earlier
    // one. All zero while nothing is pushed.
    double push = 0.0;            // along the normal in this sub-step, N s
    Vec3 drag = Vec3::Zero();     // friction's impulse in this sub-step, N s
    Vec3 up = Vec3::UnitZ();      // normal
    Vec3 lever = Vec3::Zero();    // from the body's centre
    Vec3 impulse = Vec3::Zero();  // on the node since begin()
  };
  struct Free {                           // what a free body has beside its state
    Mat3 inverse_inertia = Mat3::Zero();  // world axes; of a fixed body zero
    double inverse_mass = 0.0;
    Vec3 spin = Vec3::Zero();
    bool touched = false;
  };

  void move_bodies(const Vec3& gravity, double kick);
  void refresh(Index body);
  void guard(Index node);
  void guard_all();
  void look_for_entries();
  bool enters(const Vec3& from, const Vec3& to, Contact& contact) const;
  std::vector<Contact>::const_iterator find(Index node, Index body) const;
  bool active(Index node, Index body) const;
  void add(Contact contact);
  Contact watched(Index node, Index body) const;
  void drop_far();
  void query(Contact& c, const Vec3& at) const;
  void look_again(Contact& c, const Vec3& at) const;
  void meet(Contact& c);
  void aim(Contact& c);
  void solve_all(bool moves);
  double solve(Contact& c, double lack, bool moves);
  void leave(Contact& c, Account& account, Given& given);
  void lift(Contact& c, Vec3 x, Given& given);
  bool alone() const;
  void settle_alone(Account& account, Given& given);
  void settle_alone(std::size_t k, Account& account, Given& given);
  void lay_out();
  void take_back();
  double gap_of(std::size_t k) const;
  void stop_alone(Contact& c, double lack, Vec3& x, Vec3& v) const;
  static void book_alone(const Contact& c, const Vec3& x, const Vec3& v, Account& account);
  double rounding(const Contact& c, bool moves) const;
  double gap_at(const Contact& c, const Vec3& at) const;
  Vec3 inward(Index body, const BodyState& pose, const Vec3& x) const;
  Vec3 world_normal(const Contact& c) const;
  double inverse_mass(const Contact& c, const Vec3& direction) const;
  void push(Contact& c, const Vec3& impulse, bool moves);
  Vec3 relative_velocity(const Contact& c) const;
  void book(const Contact& c, Account& account) const;
  double gap_to(Index node, Index body) const;
  double lower_gap(Index node, Index body) const;

  const std::vector<Body>* bodies_;
  std::vector<double> radius_;
  double friction_;
  Nodes nodes_;
  double h_ = 0.0;
  std::vector<BodyState> poses_, old_poses_;
  std::vector<Free> free_;
  bool any_free_ = false;
  bool any_far_ = false;       // contacts that may be let go
  int unsettled_ = 0;          // times since begin() that turns were not enough
  double drift_ = 0.0;         // way of the fastest surface point since begin(), m
  double earliest_ = 0.0;      // drift at which a guard ends
  std::vector<double> until_;  // the same of each node
  LineVector origin_, limit_;  // of the boxes, as the nodes' coordinates
  double way_ = 0.0;           // of the fastest coordinate since begin(), m
  double due_ = 0.0;           // way_ up to which no node leaves its box
  std::vector<int> found_;
  std::vector<Contact> contacts_;  // ordered by node, then body
  // Of contacts that are alone: planes, gaps and velocities while `laid_out_`, and which were
  // pushed in the last sub-step.
  SurfacePlanes planes_;
  bool laid_out_ = false;
  std::vector<std::size_t> pushed_;
  std::vector<SweepLayout::Slot> slots_;
};

}  // namespace retiarius
