// Contact of nodes with rigid bodies by the modified mass method.
#pragma once

#include <vector>

#include "retiarius/contact/response.hpp"
#include "retiarius/contact/spec.hpp"

namespace retiarius {

// Baraff & Witkin (1998), as in Huang et al. (2022): the inverse mass of a touching node is
// filtered so that it cannot move against the surface; it is released when the surface would have
// to pull. A touching node ends the step at the thread's radius from the surface. With friction it
// first sticks (all directions blocked); where the tangential reaction exceeds friction times the
// normal one it slides, with that force against the slip, until the step ends.
//
// Entry is found by following each node's path relative to the body through the step, so a node
// does not jump through a body; segments between nodes are not seen.
class ModifiedMass final : public ContactResponse {
 public:
  // radius: of the thread at each node, m; mass: of each node, kg.
  ModifiedMass(const std::vector<Body>& bodies, std::vector<double> radius,
               std::vector<double> mass, const ContactSpec& spec);

  void begin(const Step& step, const std::vector<Vec3>& predicted,
             const std::vector<BodyState>& bodies, const std::vector<bool>& held) override;
  bool revise(const std::vector<Vec3>& x1, const std::vector<BodyState>& bodies,
              const std::vector<Vec3>& reaction, bool full) override;
  const std::vector<Constraint>& constraints() const override { return constraints_; }
  void contacts(std::vector<SolvedContact>& result) const override;

 private:
  struct Contact {
    Index node = kNone, body = kNone;
    Vec3 normal = Vec3::UnitZ();  // world
    Vec3 target = Vec3::Zero();   // where the node ends if it sticks, at the predicted pose
    Vec3 lever = Vec3::Zero();    // from the predicted mass centre to the node, m
    bool sticks = false;
    double limit = 0.0;  // friction on a sliding node at most, N
  };

  // The distance from a body's surface at a place in its axes, m. Elsewhere it is smaller by at
  // most the way there.
  struct Known {
    Vec3 place = Vec3::Zero();
    double distance = -kInfinity;
  };

  // A node's path through the step in a body's axes, as last followed, and a bound from below of
  // its distance from touching anywhere on it, m. On a path to another end that bound is smaller
  // by at most the way between the ends.
  struct Path {
    Vec3 end = Vec3::Zero();
    double clearance = -kInfinity;
  };

  Contact make_contact(Index node, Index body, const Vec3& target_in_body, bool sticks) const;
  bool find_entries(const std::vector<Vec3>& x1, const std::vector<BodyState>& bodies);
  bool entry(Index node, Index body, const Vec3& x1, const BodyState& end, Vec3& hit);
  Contact enter(Index node, Index body, const Vec3& hit, const Vec3& end) const;
  bool release(const std::vector<Vec3>& x1, const std::vector<Vec3>& reaction);
  bool revise_friction(const std::vector<Vec3>& reaction, bool changed);
  bool at_rest(const Contact& c) const;
  Vec3 carried(const Contact& c, const BodyState& pose) const;
  double normal_impulse(const Contact& c, const Vec3& x1, const Vec3& reaction) const;
  void rebuild();

  const std::vector<Body>* bodies_;
  std::vector<double> radius_, mass_;
  double friction_, friction_tolerance_;
  const Step* step_ = nullptr;
  const State* start_ = nullptr;
  std::vector<BodyState> predicted_;
  std::vector<BodyState> now_;  // at the last revision
  std::vector<Vec3> end_;       // of the nodes, then
  std::vector<bool> held_;
  std::vector<Contact> contacts_;  // ordered by node
  // Of each node, body after body: both spare questions, no more.
  std::vector<Known> known_;
  std::vector<Path> paths_;        // of this step
  std::vector<Index> contact_of_;  // of each node, or kNone
  std::vector<char> released_;     // in this step
  int revisions_ = 0;
  std::vector<Constraint> constraints_;
};

}  // namespace retiarius
