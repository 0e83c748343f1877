// Specs that the tests of this room share.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "retiarius/base/error.hpp"
#include "retiarius/net/network.hpp"

namespace retiarius::test {

inline NetSpec net_of(Pattern pattern, double side, double mesh, int segments = 1) {
  NetSpec spec;
  spec.pattern = pattern;
  spec.side = side;
  spec.mesh = mesh;
  spec.segments = segments;
  spec.thread.young_modulus = 1e6;
  spec.thread.density = 1000.0;
  spec.thread.radius = 0.01;
  return spec;
}

inline NetSpec polygon_of(int sides, double side, double mesh, int segments = 1) {
  NetSpec spec = net_of(Pattern::polygon, side, mesh, segments);
  spec.sides = sides;
  return spec;
}

inline NetSpec diamond_of(Pattern pattern, double side, double mesh, int segments = 1) {
  NetSpec spec = net_of(pattern, side, mesh, segments);
  spec.cell = Cell::diamond;
  return spec;
}

// One of each pattern, with its name.
inline std::vector<std::pair<std::string, NetSpec>> all_patterns(double side, double mesh,
                                                                 int segments) {
  return {{"hexagon", net_of(Pattern::hexagon, side, mesh, segments)},
          {"square", net_of(Pattern::square, side, mesh, segments)},
          {"square diamond", diamond_of(Pattern::square, side, mesh, segments)},
          {"triangle", net_of(Pattern::triangle, side, mesh, segments)},
          {"triangle diamond", diamond_of(Pattern::triangle, side, mesh, segments)},
          {"polygon 3", polygon_of(3, side, mesh, segments)},
          {"polygon 4", polygon_of(4, side, mesh, segments)},
          {"polygon 5", polygon_of(5, side, mesh, segments)},
          {"polygon 8", polygon_of(8, side, mesh, segments)},
          {"polygon 101", polygon_of(101, side, mesh, segments)}};
}

inline NetSpec file_of(const std::string& path, int segments = 1) {
  NetSpec spec = net_of(Pattern::file, 0.0, 0.0, segments);
  spec.file = path;
  return spec;
}

inline std::string data_file(const std::string& name) {
  return std::string(RETIARIUS_SOURCE_DIR) + "/tests/net/data/" + name;
}

// The message of the error that the call throws.
template <typename Exception, typename Call>
std::string error_of(Call&& call) {
  try {
    call();
  } catch (const Exception& error) {
    return error.what();
  }
  ADD_FAILURE() << "no error was thrown";
  return {};
}

}  // namespace retiarius::test
