// Comparisons with other programs, as the optional program retiarius-mujoco last recorded them.
#pragma once

#include <string>
#include <vector>

namespace retiarius::verification {

struct RecordedComparison {
  std::string scene, quantity, unit;
  double ours = 0.0, theirs = 0.0;       // in the unit; NaN where only their difference has a sense
  double difference = 0.0, bound = 0.0;  // in the unit
};

struct RecordedScene {
  std::string name;
  double our_time = 0.0, their_time = 0.0;  // s, of computing
};

// verification/mujoco/results.csv: lines that begin with # are paragraphs about the comparison;
// "scene,NAME,OUR_TIME,THEIR_TIME" and "value,SCENE,QUANTITY,UNIT,OURS,THEIRS,DIFFERENCE,BOUND",
// with
// "-" for a number that is absent.
struct Recorded {
  std::vector<std::string> about;
  std::vector<RecordedScene> scenes;
  std::vector<RecordedComparison> comparisons;
};

// The number as it is printed; a dash where it is absent.
std::string recorded_text(double value, int digits, const std::string& unit);

// Throws Error with the line that is wrong.
Recorded parse_recorded(const std::string& csv);

// What is built into the program; empty where nothing was recorded.
Recorded recorded_comparisons();

}  // namespace retiarius::verification
