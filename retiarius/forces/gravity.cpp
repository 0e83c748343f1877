#include "retiarius/forces/gravity.hpp"

namespace retiarius {

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
  double sum = 0.0;
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    const Vec3 weight = mass_[i] * g_;
    (*out.gradient)[i] -= weight;
    sum -= weight.dot(y[i] - step.start->x[i]);
  }
  return sum;
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
