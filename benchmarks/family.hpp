// The hexagon family by which step times are compared: side 1 m, n meshes a side, falling under
// 50 m/s2 into its held corners (Huang et al. 2022, section 3.1 and appendix, for n = 5, s = 3).
#pragma once

#include <memory>
#include <string>

#include "retiarius/motion/simulation.hpp"
#include "retiarius/net/network.hpp"

namespace retiarius::benchmarks {

struct Member {
  int n = 5;           // meshes a side
  int s = 3;           // inner nodes of a piece
  bool across = true;  // threads bend through the knots; false: hinged
  bool bending = true;
};

// r0 = 0.01 sqrt(5 / n) m for n > 5: the family's nets have the same mass.
NetSpec net_of(const Member& member);

struct Measurement {
  Member member;
  Index nodes = 0;
  double h = 0.01;  // s
  int threads = 1;
  std::string solver = "auto";  // "single": a single Newton update a step
  int steps = 0;                // of each repeat
  double step = 0.0;            // s, mean over the steps, median of the repeats
  double assembly = 0.0;        // s a step: laws and Hessian
  double factor = 0.0;          // s a step
  double solve = 0.0;           // s a step
  double rest = 0.0;            // s a step
  double iterations = 0.0;      // a step
  double factorisations = 0.0;
};

struct Settings {
  double h = 0.01;
  int steps = 100;
  int repeats = 5;
  Solver solver = Solver::automatic;
  Newton newton = Newton::converged;
  std::unique_ptr<LinearSolver> (*make_solver)() = make_net_solver;
};

// Steps the member from the flat start and times it; CPU idle besides, as far as one can have it.
Measurement measure(const Member& member, const Settings& settings);

}  // namespace retiarius::benchmarks
