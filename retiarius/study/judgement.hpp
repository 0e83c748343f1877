// Whether a number that was computed on finer and finer levels can be believed.
#pragma once

#include <optional>
#include <vector>

namespace retiarius {

enum class Verdict {
  holds,          // the last refinement changed it by no more than the tolerance
  does_not_hold,  // it changed it by more, but by less than the refinement before, or nobody knows
  chaotic,        // it changed it by more, and by no less than the refinement before
  unknown,        // fewer than two levels have it
};
const char* to_string(Verdict verdict);  // "holds", "does not hold", ...

struct Judgement {
  Verdict verdict = Verdict::unknown;
  std::optional<double> change;  // at the last refinement, over the larger of value and size
  // p, where the differences d1, d2 of the last three levels have one sign and shrink:
  // log2(d1 / d2), for levels that halve h. Absent where they are round-off.
  std::optional<double> order;
  std::optional<double> limit;  // what that order leads to: v + d2 / (2^p - 1)
};

// `values` from coarse to fine, NaN where a level failed or the quantity does not apply; `size` as
// in Quantity. A value that is there on one of the last two levels only does not hold. Levels that
// failed at the fine end are left out; between others they leave no order.
Judgement judge(std::vector<double> values, double size, double tolerance);

}  // namespace retiarius
