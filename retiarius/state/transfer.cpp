#include "retiarius/state/transfer.hpp"

namespace retiarius {

// The structured bindings name every member: one that is added does not compile until it is listed
// here (and the checkpoint's format number raised).
void transfer(Archive& archive, BodyState& state) {
  auto& [position, attitude, velocity, angular_momentum] = state;
  archive(position, attitude, velocity, angular_momentum);
}

void transfer(Archive& archive, Touch& touch) {
  auto& [node, body, sticks, reaction] = touch;
  archive(node, body, sticks, reaction);
}

void transfer(Archive& archive, Account& account) {
  auto& [material, environment, friction, impact, work, impulse, angular_impulse] = account;
  archive(material, environment, friction, impact, work, impulse, angular_impulse);
}

void transfer(Archive& archive, Memory& memory) {
  auto& [acceleration, outside_force, outside_moment, next_step, couplings] = memory;
  archive(acceleration, outside_force, outside_moment, next_step, couplings);
}

void transfer(Archive& archive, State& state) {
  auto& [time, step, x, v, bodies, touches, support, account, memory] = state;
  archive(time, step, x, v, bodies, touches, support, account, memory);
}

}  // namespace retiarius
