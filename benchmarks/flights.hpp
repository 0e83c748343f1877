// The flight of a stiff, fine net by which integrators are compared at equal accuracy: square, 5 m,
// meshes of 0.2 m, 70 GPa, tension-only, shot slowly by its corner masses; no target.
#pragma once

#include <string>
#include <vector>

#include "retiarius/motion/simulation.hpp"
#include "retiarius/net/network.hpp"

namespace retiarius::benchmarks {

NetSpec flight_net(int segments);  // of a piece between two knots

// Ways to compute it: what `auto` takes, the explicit integrator, implicit Euler, and the explicit
// scheme in its plain form (PlainExplicit).
enum class Way { automatic, explicitly, euler, plain };
const char* to_string(Way way);

struct Flight {
  int segments = 2;
  Way way = Way::automatic;
  double step = 0.005;   // s; of the plain scheme no matter
  double until = 2.0;    // s; a multiple of 0.1
  double share = 0.9;    // of the stable step, for the plain scheme
  double substep = 0.0;  // of the explicit integrator, as IntegratorSpec has it
};

// A step, s, that keeps implicit Euler's area of the mouth within 1 % up to 2 s: found by trying
// for two segments a piece (0.7 % at 0.2 ms, 1.5 % at 0.5 ms), shorter as the segments are with
// more (at four, 0.1 ms leaves 1.1 % at 1.7 s already).
double euler_step(int segments);

struct FlightResult {
  Flight flight;
  Index nodes = 0;
  std::string taken;          // by `auto`: the method's name
  double seconds = 0.0;       // wall time
  double substeps = 0.0;      // explicit ones
  double iterations = 0.0;    // Newton's
  std::vector<double> areas;  // m2, of the mouth every 0.1 s, from 0 on
  double error = 0.0;         // largest, of the areas, over the reference's
};

FlightResult fly(const Flight& flight);

// Largest relative difference between two records of the area, over the times that both have.
double area_error(const std::vector<double>& areas, const std::vector<double>& reference);

// All ways at 2, 4 and 10 segments a piece; each measured against the explicit integrator with half
// of its sub-step where `references` says so, else against that with its own. implicit Euler goes
// in the steps of euler_step(), with more than two segments a piece for the first 0.2 s only.
// `told` hears of each result.
struct FlightsOptions {
  std::vector<int> segments{2, 4, 10};
  double until = 2.0;
  bool references = false;
};
std::vector<FlightResult> measure_flights(const FlightsOptions& options,
                                          void (*told)(const FlightResult&));

}  // namespace retiarius::benchmarks
