#include "retiarius/measure/energy_balance.hpp"

#include "retiarius/measure/energy.hpp"

namespace retiarius {

namespace {

double losses(const Account& a) {
  return a.material_loss + a.environment_loss + a.friction_loss + a.impact_loss;
}

}  // namespace

Energies energies(const Simulation& simulation, const Vec3& g) {
  const Network& network = simulation.network();
  const State& state = simulation.state();
  return {kinetic_energy(network, simulation.bodies(), state), simulation.stretching_energy(),
          simulation.bending_energy(), gravity_energy(network, simulation.bodies(), state, g)};
}

void EnergyBalance::begin(const Simulation& simulation) {
  gravity_ = simulation.environment().gravity;
  first_moment_ = first_moment(simulation.network(), simulation.bodies(), simulation.state());
  start_ = energies(simulation, gravity_).sum();
  account_ = simulation.state().account;
}

void EnergyBalance::see(const Simulation& simulation) {
  const Vec3& g = simulation.environment().gravity;
  start_ -= (g - gravity_).dot(first_moment_);
  gravity_ = g;
  first_moment_ = first_moment(simulation.network(), simulation.bodies(), simulation.state());
}

double EnergyBalance::integrator_loss(const Energies& present, const Account& account) const {
  const double work = account.prescribed_work - account_.prescribed_work;
  const double lost = losses(account) - losses(account_);
  return start_ + work - present.sum() - lost;
}

}  // namespace retiarius
