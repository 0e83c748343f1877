// A verification case: what is computed, and what it is compared with.
#pragma once

#include <string>
#include <vector>

#include "verification/framework/context.hpp"

namespace retiarius::verification {

enum class Group { paper, rods, cables, dynamics, contact, deployment, convergence };
const char* title(Group group);

struct Case {
  std::string name;   // its folder: "heavy-cantilever"
  std::string title;  // "Heavy cantilever: linear theory, elastica, both curvatures"
  Group group = Group::paper;
  std::string figure;  // of the paper: "Fig. 14"; empty: none
  std::string about;   // what is computed, with what, and what is compared: a short paragraph
  std::string source;  // of the references, unless a comparison names its own
  // What the case must notice when it is scaled by two, of fault_names(); tested for every one.
  std::vector<std::string> guards;
  void (*run)(Context&) = nullptr;
};

// All cases, in the order of the list in verification/CMakeLists.txt.
const std::vector<Case>& all_cases();

}  // namespace retiarius::verification
