#include "retiarius/forces/gravity.hpp"

namespace retiarius {

// Measured from the start positions: the smaller the number, the finer the line search sees.
double Gravity::potential(const Step& step, const std::vector<Vec3>& y) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < mass_.size(); ++i) sum -= mass_[i] * g_.dot(y[i] - step.start->x[i]);
  return sum;
}

void Gravity::assemble(const Step&, const std::vector<Vec3>&, Assembly& out) const {
  for (std::size_t i = 0; i < mass_.size(); ++i) (*out.gradient)[i] -= mass_[i] * g_;
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
