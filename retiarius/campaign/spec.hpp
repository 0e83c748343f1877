// A campaign: many runs of one mission with varied or random inputs, as plain validated data.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "retiarius/base/error.hpp"
#include "retiarius/base/vec.hpp"

namespace retiarius {

// How the runs are spread over the variables.
enum class Design { grid, list, latin_hypercube, sobol, monte_carlo, saltelli };

// How one variable is distributed.
enum class Distribution {
  values,            // the numbers of `values`, one after another
  uniform,           // between low and high
  normal,            // mean, deviation
  truncated_normal,  // normal within low and high
  lognormal,         // median, and the deviation of the natural logarithm
  uniform_attitude,  // every attitude alike; sets a rotation vector in degrees
  cone,              // a direction, uniform over the solid angle of a cone; sets a vector
};

// [[variable]]
struct VariableSpec {
  std::string name;               // of the columns of inputs; default: the last name of its path
  std::vector<std::string> sets;  // dotted paths of the mission, as --set takes them
  Distribution distribution = Distribution::uniform;
  std::vector<double> values;
  double low = 0.0, high = 0.0;
  double mean = 0.0, deviation = 0.0;  // of a lognormal variable: of its natural logarithm
  double median = 0.0;
  Vec3 axis = Vec3::UnitZ();
  double half_angle_deg = 0.0;
  double length = 1.0;  // of the vector that a cone sets
  int levels = 0;       // of a grid over a distribution: as many quantiles
  SourcePlace place;

  // Coordinates of the unit cube that it takes, and inputs that it writes: 1, 2 or 3.
  int dimensions() const;
};

// [[group]]: variables that are correlated by a Gaussian copula.
struct GroupSpec {
  std::vector<std::string> variables;
  std::vector<double> correlation;  // a matrix, row by row, of the normal scores
  SourcePlace place;
};

// [plan]
struct PlanSpec {
  Design design = Design::monte_carlo;
  std::int64_t runs = 0;   // saltelli: blocks, of k + 2 runs each; grid, list: follows from values
  std::uint64_t seed = 0;  // of everything random
};

enum class Keep { measures, history, failures, sample, all };

// [keep]: what stays on disk of each run beside its row.
struct KeepSpec {
  Keep what = Keep::measures;
  std::vector<double> ids;  // sample: of these runs
  std::int64_t every = 0;   // sample: of each run whose id is a multiple
};

// [limits] of each run.
struct LimitSpec {
  double time = kInfinity;        // s, of the mission
  std::int64_t steps = 0;         // 0: none
  double wall_clock = kInfinity;  // s
  std::int64_t attempts = 2;      // of a run whose process dies
};

// [stop]
struct StopSpec {
  double width = 0.0;  // of the interval of the success rate; 0: never
  double confidence = 0.95;
  std::int64_t batch = 100;  // runs between decisions
};

struct CampaignSpec {
  std::string title;
  std::string mission;            // file, relative to the campaign's
  std::vector<std::string> sets;  // overrides of every run, "path=value"
  SourcePlace sets_place;
  std::string kernels = "auto";
  PlanSpec plan;
  std::vector<VariableSpec> variables;
  std::vector<GroupSpec> groups;
  KeepSpec keep;
  LimitSpec limits;
  StopSpec stop;
  std::string file;       // where it was read from; empty for text
  std::string folder;     // that relative paths start from
  std::string canonical;  // the file's content without comments and layout

  std::string mission_path() const;
  // Names of the inputs, one for each coordinate of the unit cube: the variable's own, or
  // "NAME.yaw", "NAME.pitch", "NAME.roll" (deg) and "NAME.angle", "NAME.azimuth" (deg).
  std::vector<std::string> input_names() const;
};

}  // namespace retiarius
