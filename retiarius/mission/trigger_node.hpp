// The tree behind Trigger.
#pragma once

#include <memory>
#include <vector>

#include "retiarius/mission/trigger.hpp"

namespace retiarius {

enum class TriggerKind { any, all, flag, comparison };
enum class Comparison { at_least, above, at_most, below };

struct Trigger::Node {
  TriggerKind kind = TriggerKind::flag;
  std::vector<std::shared_ptr<const Node>> parts;  // of any and all
  const TriggerName* name = nullptr;               // of flag and comparison
  Comparison comparison = Comparison::at_least;
  double number = 0.0;
};

}  // namespace retiarius
