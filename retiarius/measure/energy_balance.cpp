#include "retiarius/measure/energy_balance.hpp"

#include "retiarius/measure/energy.hpp"

namespace retiarius {

namespace {

double losses(const Account& a) {
  return a.material_loss + a.environment_loss + a.friction_loss + a.impact_loss;
}

// Bodies that are held take no part in gravity.
const std::vector<Body>& falling_bodies(const Simulation& simulation) {
  static const std::vector<Body> none;
  return simulation.bodies_held() ? none : simulation.bodies();
}

}  // namespace

Energies energies(const Simulation& simulation, const Vec3& g) {
  const Network& network = simulation.network();
  const State& state = simulation.state();
  return {kinetic_energy(network, simulation.bodies(), state), simulation.stretching_energy(),
          simulation.bending_energy(),
          gravity_energy(network, falling_bodies(simulation), state, g),
          simulation.contact_energy()};
}

void EnergyBalance::begin(const Simulation& simulation) {
  remember(simulation);
  start_ = energies(simulation, gravity_).sum();
  account_ = simulation.state().account;
}

void EnergyBalance::see(const Simulation& simulation) {
  const Vec3 moment = simulation.bodies_held() ? net_moment_ : whole_moment_;
  start_ += gravity_.dot(moment_) - simulation.environment().gravity.dot(moment);
  remember(simulation);
}

void EnergyBalance::remember(const Simulation& simulation) {
  const Network& network = simulation.network();
  gravity_ = simulation.environment().gravity;
  net_moment_ = first_moment(network, {}, simulation.state());
  whole_moment_ = first_moment(network, simulation.bodies(), simulation.state());
  moment_ = simulation.bodies_held() ? net_moment_ : whole_moment_;
}

double EnergyBalance::integrator_loss(const Energies& present, const Account& account) const {
  const double work = account.prescribed_work - account_.prescribed_work;
  const double lost = losses(account) - losses(account_);
  return start_ + work - present.sum() - lost;
}

}  // namespace retiarius
