#include "retiarius/mission/trigger.hpp"

#include <algorithm>
#include <cmath>

#include "retiarius/mission/trigger_node.hpp"

namespace retiarius {

const std::vector<TriggerName>& trigger_names() {
  static const std::vector<TriggerName> names = {
      {"time", "s", "time since the mission's start", &TriggerValues::time, nullptr},
      {"phase_time", "s", "time since the phase's start", &TriggerValues::phase_time, nullptr},
      {"mouth_area", "m2",
       "area of the mouth, projected along the shot axis (before a shot: the flat net's normal)",
       &TriggerValues::mouth_area, nullptr},
      {"mouth_ratio", "", "mouth_area over that of the flat net", &TriggerValues::mouth_ratio,
       nullptr},
      {"distance", "m", "mean travel of the corners along the shot axis since the shot",
       &TriggerValues::distance, nullptr},
      {"contact", "", "a thread has touched a target", nullptr, &TriggerValues::contact},
      {"widest", "", "mouth_area has fallen 1 % from its maximum", nullptr,
       &TriggerValues::widest}};
  return names;
}

namespace {

bool is_time(const TriggerName& name) {
  return name.value == &TriggerValues::time || name.value == &TriggerValues::phase_time;
}

bool compare(double value, Comparison comparison, double number, double tolerance) {
  switch (comparison) {
    case Comparison::at_least:
      return value >= number - tolerance;
    case Comparison::above:
      return value > number + tolerance;
    case Comparison::at_most:
      return value <= number + tolerance;
    case Comparison::below:
      return value < number - tolerance;
  }
  return false;
}

template <class Node>
bool is_true(const Node& node, const TriggerValues& values) {
  const auto part = [&values](const auto& p) { return is_true(*p, values); };
  switch (node.kind) {
    case TriggerKind::any:
      return std::any_of(node.parts.begin(), node.parts.end(), part);
    case TriggerKind::all:
      return std::all_of(node.parts.begin(), node.parts.end(), part);
    case TriggerKind::flag:
      return values.*(node.name->flag);
    case TriggerKind::comparison:
      break;
  }
  const double tolerance = is_time(*node.name) ? 1e-9 * std::max(1.0, std::abs(node.number)) : 0.0;
  return compare(values.*(node.name->value), node.comparison, node.number, tolerance);
}

template <class Node>
bool names_it(const Node& node, const std::string& name) {
  if (node.name && node.name->name == name) return true;
  return std::any_of(node.parts.begin(), node.parts.end(),
                     [&name](const auto& p) { return names_it(*p, name); });
}

// Infinite where nothing is certain. Only "not before" comparisons of time stay true.
template <class Node>
double certain_at(const Node& node, double phase_start) {
  if (node.kind == TriggerKind::any || node.kind == TriggerKind::all) {
    const bool any = node.kind == TriggerKind::any;
    double when = any ? kInfinity : -kInfinity;
    for (const auto& p : node.parts) {
      const double at = certain_at(*p, phase_start);
      when = any ? std::min(when, at) : std::max(when, at);
    }
    return when;
  }
  const bool lower_bound =
      node.kind == TriggerKind::comparison &&
      (node.comparison == Comparison::at_least || node.comparison == Comparison::above);
  if (!lower_bound || !is_time(*node.name)) return kInfinity;
  const bool since_phase = node.name->value == &TriggerValues::phase_time;
  return node.number + (since_phase ? phase_start : 0.0);
}

}  // namespace

bool Trigger::evaluate(const TriggerValues& values) const {
  return root_ && is_true(*root_, values);
}

bool Trigger::uses(const std::string& name) const { return root_ && names_it(*root_, name); }

std::optional<double> Trigger::latest_time(double phase_start) const {
  const double at = root_ ? certain_at(*root_, phase_start) : kInfinity;
  if (!std::isfinite(at)) return std::nullopt;
  return std::max(at, phase_start);
}

}  // namespace retiarius
