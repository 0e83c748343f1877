// Deliberate faults, by which tests learn whether the cases notice a wrong law.
#pragma once

#include <string>

#include "retiarius/mission/mission.hpp"
#include "retiarius/net/network.hpp"
#include "retiarius/state/law.hpp"

namespace retiarius::verification {

// What can be scaled: the laws by their names ("stretching", "bending", "gravity",
// "environment damping"), and what belongs to no law of its own ("material damping", "friction",
// "mass").
struct Fault {
  std::string law;  // empty: none
  double factor = 1.0;

  bool hits(const std::string& name) const { return law == name; }
};

// The names that a fault may have.
const std::vector<std::string>& fault_names();

// Scales potential, gradient and Hessian of the law that the fault names.
LawWrapper law_wrapper(const Fault& fault);

// Applies what the wrapper cannot: to materials and masses, and to the coefficient of friction.
void spoil(const Fault& fault, Network& network);
void spoil(const Fault& fault, ContactSpec& contact);

}  // namespace retiarius::verification
