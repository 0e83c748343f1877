// Measurements as CSV, JSON and text.
#pragma once

#include <string>
#include <vector>

#include "benchmarks/family.hpp"

namespace retiarius::benchmarks {

// A line of names and a line a measurement; lines that begin with # tell machine and build.
std::string results_csv(const std::vector<Measurement>& measurements);
std::string results_json(const std::vector<Measurement>& measurements);

// One line of the table that the program prints, and its heading; times in ms.
std::string heading_text();
std::string measurement_text(const Measurement& measurement);

}  // namespace retiarius::benchmarks
