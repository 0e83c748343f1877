// Whether the mouth is shut for good.
#pragma once

#include <optional>

#include "retiarius/base/archive.hpp"
#include "retiarius/measure/readings.hpp"

namespace retiarius {

// Closed: mouth area and vector area below 5 % and width below 10 % of the flat net's, at every
// accepted step of the last 0.5 s, in which nothing moved the net by prescription. A small
// projected area alone is not enough: a mouth seen edge-on, or crossed, shows none.
class Closure {
 public:
  Closure(double flat_area, double flat_width) : area_(flat_area), width_(flat_width) {}

  // From now on nodes are moved by prescription, or no longer.
  void set_prescribed(double time, bool prescribed);
  void see(double time, const Readings& readings);

  bool closed() const;

  // For checkpoints; see base/archive.hpp.
  void transfer(Archive& archive) { archive(now_, small_since_, free_since_); }

 private:
  double area_;   // m2
  double width_;  // m
  double now_ = 0.0;
  std::optional<double> small_since_;  // s
  std::optional<double> free_since_;   // s
};

}  // namespace retiarius
