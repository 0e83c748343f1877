// What `auto` stands for: the integrator and the linear solver by predicted cost.
#pragma once

#include <string>

#include "retiarius/contact/spec.hpp"
#include "retiarius/motion/spec.hpp"
#include "retiarius/net/network.hpp"

namespace retiarius {

// The counts that costs are predicted from: of the net, of its matrix's factor, and of time scales.
// Never clocks: the same mission takes the same way on every machine.
struct WorkCounts {
  double nodes = 0.0, inner = 0.0;  // all; those that a single thread runs through
  double pairs = 0.0;               // of nodes that a law couples
  double joints = 0.0;              // that bend
  double factor_flops = 0.0, factor_entries = 0.0;
  double stable_step = kInfinity;  // of the explicit integrator, s
  double crossing = kInfinity;     // of an axial wave through the mean piece between knots, s
  bool compression = true;         // all threads carry it
};
WorkCounts count_work(const Network& network);  // without pairs and factor

// Predicted time of a processor core for a second of the motion, s, by constants that were measured
// once (see the theory's section on the choice of the integrator).
double explicit_cost(const WorkCounts& work, const IntegratorSpec& integrator);
// Of implicit Euler in steps of length h, s.
double implicit_cost(const WorkCounts& work, const IntegratorSpec& integrator, double h);
// The step at which implicit Euler is about as accurate as is asked: integrator.step, but of
// threads that cannot push at most a few crossings, since it takes snaps of such threads for
// plastic.
double comparable_step(const WorkCounts& work, const IntegratorSpec& integrator);
// Of one solution by conjugate gradients, and of a factorisation with it, s.
double gradients_cost(const WorkCounts& work, double h);
double factor_cost(const WorkCounts& work);

// What was taken, and why in words. A reason is empty where the mission names the method itself.
struct Choice {
  Method method = Method::implicit_euler;
  Solver solver = Solver::direct;  // without meaning for the explicit integrator
  std::string method_reason, solver_reason;
};
// bodies: whether there are any to touch.
Choice choose(const WorkCounts& work, const IntegratorSpec& integrator, const ContactSpec& contact,
              bool bodies);

const char* to_string(Solver solver);

}  // namespace retiarius
