// The face of every contact response: how touching bodies constrain a step.
#pragma once

#include <vector>

#include "retiarius/base/vec.hpp"
#include "retiarius/bodies/body.hpp"
#include "retiarius/state/constraints.hpp"
#include "retiarius/state/state.hpp"
#include "retiarius/state/step.hpp"

namespace retiarius {

// A contact of the step that was solved, as the accounts and the next step need it.
struct SolvedContact {
  Index node = kNone;
  Index body = kNone;
  bool sticks = false;
  Vec3 normal = Vec3::UnitZ();  // out of the body
  // Where body and node push each other at the step's end, m: the node's place, so that the pair
  // of forces has no moment.
  Vec3 point = Vec3::Zero();
  Mat3 blocked = Mat3::Zero();
};

class ContactResponse {
 public:
  virtual ~ContactResponse() = default;

  // Starts a step, which must outlive it: where nodes and bodies would be at its end without new
  // contact. `held`: nodes that prescribed motion takes out of contact.
  virtual void begin(const Step& step, const std::vector<Vec3>& predicted,
                     const std::vector<BodyState>& bodies, const std::vector<bool>& held) = 0;

  // Revises contacts for the present end positions, bodies and the blocked part of the force on
  // each node (N); true if anything changed. `full`: the iteration has converged.
  virtual bool revise(const std::vector<Vec3>& x1, const std::vector<BodyState>& bodies,
                      const std::vector<Vec3>& reaction, bool full) = 0;

  // The constraints of the present contacts, ordered by node.
  virtual const std::vector<Constraint>& constraints() const = 0;
  // The step's start state must still be there.
  virtual void contacts(std::vector<SolvedContact>& result) const = 0;
};

}  // namespace retiarius
