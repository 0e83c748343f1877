// The condition that ends a phase: comparisons of measures joined by `and` and `or`.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "retiarius/base/error.hpp"
#include "retiarius/base/vec.hpp"

namespace retiarius {

// What triggers look at, after each accepted step.
struct TriggerValues {
  double time = 0.0;         // s, of the mission
  double phase_time = 0.0;   // s, since the phase's start
  double mouth_area = 0.0;   // m2
  double mouth_ratio = 0.0;  // mouth_area over that of the flat net
  double distance = 0.0;     // m, travel of the corners along the shot axis since the shot
  bool contact = false;      // a thread touches or has touched a body
  bool widest = false;       // the mouth's area has fallen 1 % from its maximum
};

// A name that triggers know; `value` for quantities, `flag` for words that are true or false.
struct TriggerName {
  std::string name;
  std::string unit;
  std::string meaning;
  double TriggerValues::*value = nullptr;
  bool TriggerValues::*flag = nullptr;
};
const std::vector<TriggerName>& trigger_names();

// A parsed expression. `and` binds tighter than `or`; parentheses group:
//   expression = all {"or" all};  all = one {"and" one}
//   one = "(" expression ")" | flag | quantity (">=" | ">" | "<=" | "<") number
class Trigger {
 public:
  // Throws InputError at the column inside the text; `place` is that of its first character, `key`
  // the name of what holds it.
  static Trigger parse(const std::string& text, const SourcePlace& place = {},
                       const std::string& key = "trigger");

  // Values within 1e-9 max(1, |number|) of the number count as equal to it for time and
  // phase_time, whose values are products with round-off.
  bool evaluate(const TriggerValues& values) const;

  const std::string& text() const { return text_; }
  bool uses(const std::string& name) const;

  // The mission time at which the trigger is true whatever happens, for a phase that starts at
  // phase_start; none if there is no such time.
  std::optional<double> latest_time(double phase_start) const;

 private:
  friend class TriggerParser;
  struct Node;

  std::string text_;
  std::shared_ptr<const Node> root_;
};

}  // namespace retiarius
