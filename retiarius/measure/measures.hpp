// The measures of a whole run or phase, as summary.json lists them.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace retiarius {

// A measure is a number, an integer count, a truth value, or absent (null).
struct Measure {
  std::string name;
  std::string unit;
  std::variant<std::monostate, double, std::int64_t, bool> value;
};
using Measures = std::vector<Measure>;

}  // namespace retiarius
