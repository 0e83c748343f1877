#include "retiarius/forces/gravity.hpp"

#include "retiarius/base/parallel.hpp"

namespace retiarius {

namespace {
constexpr std::size_t kNodes = 4096;  // that a thread takes at once
}

// Measured from the start positions: the smaller the number, the finer the line search sees.
double Gravity::potential(const Step& step, const std::vector<Vec3>& y) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    const Vec3 weight = mass_[i] * g_;
    sum -= weight.dot(y[i] - step.start->x[i]);
  }
  return sum;
}

double Gravity::assemble(const Step& step, const std::vector<Vec3>& y, Assembly& out) const {
  return parallel_sum(mass_.size(), kNodes, [&](std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3 weight = mass_[i] * g_;
      (*out.gradient)[i] -= weight;
      sum -= weight.dot(y[i] - step.start->x[i]);
    }
    return sum;
  });
}

void Gravity::account(const Step& step, const std::vector<Vec3>& y, const std::vector<Vec3>&,
                      Exchange& exchange) const {
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    const Vec3 impulse = step.h * mass_[i] * g_;
    exchange.outside_impulse += impulse;
    exchange.outside_angular_impulse += y[i].cross(impulse);
  }
}

}  // namespace retiarius
