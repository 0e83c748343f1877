// What a convergence study draws.
#pragma once

#include <vector>

#include "retiarius/report/chart.hpp"
#include "retiarius/study/converge.hpp"

namespace retiarius {

// For one series: mouth area, peak tension and energies against time, a curve for each level that
// came to its end; then the measures against the size of step or mesh, as distances from their
// values on the finest level.
std::vector<Chart> converge_charts(const Study& study, std::size_t series);

}  // namespace retiarius
