// The energy that the integrator lost: what no other cause accounts for.
#pragma once

#include "retiarius/motion/simulation.hpp"
#include "retiarius/state/transfer.hpp"

namespace retiarius {

// Mechanical energies of the present state, J.
struct Energies {
  double kinetic = 0.0;
  double stretching = 0.0;
  double bending = 0.0;
  double gravity = 0.0;
  double contact = 0.0;  // of the barriers
  double sum() const { return kinetic + stretching + bending + gravity + contact; }
};

// Measured with the gravity g, m/s2.
Energies energies(const Simulation& simulation, const Vec3& g);

// Integrator loss = energy at the start + prescribed work - present energy - the other losses.
//
// Where a phase brings another gravity, the energy in its field jumps although nothing happens.
// That jump, -(g_new - g_old).sum(m x) at the places where it happens, is added to the energy at
// the start, so that it is nobody's loss.
class EnergyBalance {
 public:
  void begin(const Simulation& simulation);

  // To be called once after the surroundings may have changed, and after every step.
  void see(const Simulation& simulation);

  // That the balance reckons with, m/s2.
  const Vec3& gravity() const { return gravity_; }

  double integrator_loss(const Energies& present, const Account& account) const;  // J

  // For checkpoints; see base/archive.hpp.
  void transfer(Archive& archive) {
    archive(start_, account_, gravity_, net_moment_, whole_moment_, moment_);
  }

 private:
  void remember(const Simulation& simulation);

  double start_ = 0.0;           // J
  Account account_;              // at the start
  Vec3 gravity_ = Vec3::Zero();  // m/s2
  // Sums of m x at the last look, kg m: of the net, with the free bodies, and of what gravity
  // acted on.
  Vec3 net_moment_ = Vec3::Zero(), whole_moment_ = Vec3::Zero(), moment_ = Vec3::Zero();
};

}  // namespace retiarius
