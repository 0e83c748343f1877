// The extremes of a run or phase.
#pragma once

#include <cstdint>
#include <optional>

#include "retiarius/base/archive.hpp"
#include "retiarius/measure/readings.hpp"

namespace retiarius {

// Where something was touched first.
struct FirstTouch {
  Index thread = kNone;       // into Network::threads
  Index body = kNone;         // the mission's targets, from 0
  Vec3 place = Vec3::Zero();  // of contact, in the body's axes, m

  void transfer(Archive& archive) { archive(thread, body, place); }
};

// What was largest, smallest or first since a start. Shapes count from the start itself, tensions
// and contacts, which belong to steps, from the first step after it.
struct Peaks {
  double mouth_area = -1.0;        // largest, m2
  double mouth_area_time = 0.0;    // when, s
  double mouth_area_travel = 0.0;  // of the corners then, m
  std::optional<double> tension;   // N
  double strain = -1.0;
  std::optional<double> first_contact;      // s
  FirstTouch first_touch;                   // then
  std::optional<double> smallest_distance;  // m
  std::int64_t steps = 0;
  std::int64_t iterations = 0;  // Newton's

  // travel: mean displacement of the corners along the axis since the shot, m.
  void see_shape(double time, const Readings& readings, double travel);
  void see_step(int newton_iterations, double peak_tension);
  // At the first step in which anything is touched; later ones change nothing.
  void see_touch(double time, const FirstTouch& touch);

  // For checkpoints; see base/archive.hpp.
  void transfer(Archive& archive) {
    archive(mouth_area, mouth_area_time, mouth_area_travel, tension, strain, first_contact,
            first_touch, smallest_distance, steps, iterations);
  }
};

}  // namespace retiarius
