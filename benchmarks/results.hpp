// Measurements as CSV, JSON and text.
#pragma once

#include <string>
#include <vector>

#include "benchmarks/family.hpp"
#include "benchmarks/flights.hpp"
#include "benchmarks/missions.hpp"

namespace retiarius::benchmarks {

// A line of names and a line a measurement; lines that begin with # tell machine and build.
std::string results_csv(const std::vector<Measurement>& measurements);
std::string results_json(const std::vector<Measurement>& measurements);

std::string flights_csv(const std::vector<FlightResult>& results);
std::string missions_csv(const std::vector<MissionTime>& times);

// The p of time ~ nodes^p between two sizes.
double growth_exponent(const Measurement& small, const Measurement& large);
// What of each thread's time is of use, against the run with fewer; at most about 1.
double parallel_efficiency(const Measurement& one, const Measurement& more);

// One line of the table that the program prints, and its heading; times in ms.
std::string heading_text();
std::string measurement_text(const Measurement& measurement);
std::string flight_heading_text();
std::string flight_text(const FlightResult& result);
std::string mission_heading_text();
std::string mission_text(const MissionTime& time);

}  // namespace retiarius::benchmarks
