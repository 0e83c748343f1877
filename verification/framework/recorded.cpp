#include "verification/framework/recorded.hpp"

#include <cmath>
#include <cstdlib>
#include <sstream>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "verification/framework/comparison_text.hpp"
#include "verification/framework/context.hpp"

namespace retiarius::verification {

namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream text(line);
  for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
  return cells;
}

double number(const std::string& cell, const std::string& line) {
  if (cell == "-") return NAN;
  char* end = nullptr;
  const double value = std::strtod(cell.c_str(), &end);
  if (cell.empty() || *end != '\0')
    throw Error(fmt::format("recorded comparisons: \"{}\" is no number in \"{}\"", cell, line));
  return value;
}

}  // namespace

std::string recorded_text(double value, int digits, const std::string& unit) {
  if (std::isnan(value)) return "\u2013";
  return printed(value, digits) + unit_text(unit);
}

Recorded parse_recorded(const std::string& csv) {
  Recorded recorded;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) continue;
    if (line.front() == '#') {
      recorded.about.push_back(line.substr(line.size() > 1 && line[1] == ' ' ? 2 : 1));
      continue;
    }
    const std::vector<std::string> c = cells_of(line);
    const auto value = [&](std::size_t k) { return number(c[k], line); };
    if (c[0] == "scene" && c.size() == 4)
      recorded.scenes.push_back({c[1], value(2), value(3)});
    else if (c[0] == "value" && c.size() == 8)
      recorded.comparisons.push_back({c[1], c[2], c[3], value(4), value(5), value(6), value(7)});
    else
      throw Error(fmt::format("recorded comparisons: a line of neither kind: \"{}\"", line));
  }
  return recorded;
}

Recorded recorded_comparisons() {
  const auto at = embedded_files().find("mujoco/results.csv");
  return at == embedded_files().end() ? Recorded{} : parse_recorded(at->second);
}

}  // namespace retiarius::verification
