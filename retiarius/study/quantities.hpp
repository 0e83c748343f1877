// What a convergence study compares: the numbers that a run ends with.
#pragma once

#include <string>
#include <vector>

#include "retiarius/measure/history.hpp"
#include "retiarius/mission/mission.hpp"
#include "retiarius/mission/observer.hpp"

namespace retiarius {

struct Quantity {
  std::string name;  // "peak_tension"; of a phase "spread.peak_tension"; of a probe "center.z"
  std::string unit;
  double value = 0.0;  // truth values are 0 and 1, with unit "yes/no"; NaN: does not apply
  // What changes are compared with where the value itself is smaller: the net's width for places,
  // the largest energy for energies, the thread's radius for distances, 1 for relative drifts.
  double size = 0.0;
};

// Measures of the whole run, energies and probes of its last row, and where there are several
// phases the measures of each, with their ends. Counts of steps and iterations, times of the clock
// and the flat net's sizes are no results and left out.
std::vector<Quantity> run_quantities(const Mission& mission, const RunReport& report,
                                     const std::vector<HistoryRow>& rows);

// Null where there is none of this name.
const Quantity* find_quantity(const std::vector<Quantity>& quantities, const std::string& name);

}  // namespace retiarius
