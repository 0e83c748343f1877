// The runs of a convergence study: the mission, and the same with finer steps or a finer mesh.
#pragma once

#include <string>
#include <vector>

#include "retiarius/mission/mission.hpp"

namespace retiarius {

enum class Vary { step, mesh, both };

// One run of a study.
struct Level {
  std::string name;  // "as given", "h = 0.005 s", "8 segments a piece"
  Mission mission;
  int step_halvings = 0;
  int mesh_doublings = 0;
  double nodes = 0.0;
  double steps = 0.0;  // accepted steps at the most; 0 where the end is not known before
  double cost = 1.0;   // steps times nodes, that of the mission as given being 1
};

// Levels that differ in one thing, the mission as given first: places in Plan::levels.
struct Series {
  Vary vary = Vary::step;  // step or mesh
  std::string name;        // "time step", "mesh"
  std::vector<std::size_t> levels;
  std::vector<double> sizes;  // of each level: the first phase's step, s; mesh over segments, m
};

struct Plan {
  std::vector<Level> levels;
  std::vector<Series> series;
  std::vector<std::string> notes;  // what was left out, and why

  double cost() const;  // of all levels
};

// `count` levels a series, at least 2: steps of h, h/2, h/4 ..., in every phase; segments a piece
// (and a bridle) n, 2n, 4n ... The output interval, a multiple of the step, stays one. With
// Vary::both what cannot be varied is left out with a note; by itself it is an InputError: the step
// of a mission that is solved statically throughout, the mesh of a net read from a file or started
// from a saved state, and of a mission that names nodes inside a piece by index.
Plan plan_levels(const Mission& mission, int count, Vary vary);

}  // namespace retiarius
