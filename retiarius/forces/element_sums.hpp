// Where a law's kernels add what an assembly wants.
#pragma once

#include "retiarius/forces/element_kernels.hpp"
#include "retiarius/state/law.hpp"

namespace retiarius {

inline kernels::ElementSums element_sums(Assembly& out) {
  kernels::ElementSums sums{out.gradient->front().data(), nullptr, nullptr};
  if (!out.hessian) return sums;
  sums.diagonal = out.hessian->diagonal.front().data();
  sums.below = out.hessian->below.empty() ? nullptr : out.hessian->below.front().data();
  return sums;
}

}  // namespace retiarius
