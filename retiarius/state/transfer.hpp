// The state as bytes and back; see base/archive.hpp.
#pragma once

#include "retiarius/base/archive.hpp"
#include "retiarius/state/state.hpp"

namespace retiarius {

void transfer(Archive& archive, BodyState& state);
void transfer(Archive& archive, Touch& touch);
void transfer(Archive& archive, Account& account);
void transfer(Archive& archive, Memory& memory);
void transfer(Archive& archive, State& state);

}  // namespace retiarius
