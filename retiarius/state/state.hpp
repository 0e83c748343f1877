// The mutable state of a simulation: exactly what a checkpoint saves and a resumed run needs.
#pragma once

#include <cstdint>
#include <vector>

#include "retiarius/base/vec.hpp"

namespace retiarius {

// A rigid body's state. Attitude turns body axes into world axes. The angular momentum about the
// mass centre, in world axes, is carried instead of the spin, so that free tumbling conserves it
// exactly whatever integrator moves the net.
struct BodyState {
  Vec3 position = Vec3::Zero();          // of the mass centre, m
  Quat attitude = Quat::Identity();      // unit quaternion, body to world
  Vec3 velocity = Vec3::Zero();          // m/s
  Vec3 angular_momentum = Vec3::Zero();  // about the mass centre, world axes, kg m2/s
};

// A node that touched a body at the end of the last step, and whether it stuck to it.
struct Touch {
  Index node = kNone;
  Index body = kNone;
  bool sticks = false;
  Vec3 reaction = Vec3::Zero();  // force of the body on the node, world axes, N
};

// What has been gained and lost since the start of the run, J and N s; energies that are functions
// of the present state (kinetic, stretching, ...) are not stored but measured.
struct Account {
  double material_loss = 0.0;                   // to Kelvin-Voigt damping of the threads
  double environment_loss = 0.0;                // to environmental damping
  double friction_loss = 0.0;                   // to Coulomb friction
  double impact_loss = 0.0;                     // to plastic impact of nodes on bodies
  double prescribed_work = 0.0;                 // done on the net by supports, grips and shots
  Vec3 outside_impulse = Vec3::Zero();          // of gravity, damping, supports and shots
  Vec3 outside_angular_impulse = Vec3::Zero();  // the same about the origin, N m s
};

// What a time integrator carries from step to step besides positions and velocities. Empty and zero
// at a start; an integrator that finds nothing here starts up from the present forces.
struct Memory {
  // Each node's acceleration by the laws alone, m/s2, for generalised alpha and for the first guess
  // of implicit Euler; empty: not known.
  std::vector<Vec3> acceleration;
  // What outside forces have in the sum of m times those, N, and their moment about the origin.
  Vec3 outside_force = Vec3::Zero();
  Vec3 outside_moment = Vec3::Zero();
  double next_step = 0.0;  // tried next where adaptive or after a cut, s; 0: none yet
  // Of the solver: pairs of nodes, one after the other, that threads in contact have coupled in
  // its matrix, whose order of elimination they steer.
  std::vector<Index> couplings;
};

struct State {
  double time = 0.0;      // s, since the mission's start
  std::int64_t step = 0;  // accepted steps since the mission's start
  std::vector<Vec3> x;    // node positions, m
  std::vector<Vec3> v;    // node velocities, m/s
  std::vector<BodyState> bodies;
  std::vector<Touch> touches;  // ordered by node
  std::vector<Vec3> support;   // force of supports on each node at the end of the last step, N
  Account account;
  Memory memory;
};

}  // namespace retiarius
