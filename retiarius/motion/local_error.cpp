#include "retiarius/motion/local_error.hpp"

#include <algorithm>
#include <cmath>

#include "retiarius/motion/integrator.hpp"

namespace retiarius {

namespace {

constexpr double kSafety = 0.9;
constexpr double kMostGrowth = 2.0;
constexpr double kLeastGrowth = 1.02;  // also of an acceleration that is never forgotten
constexpr double kMostShrinkage = 0.2;

std::vector<Vec3> combined(double c_a, const std::vector<Vec3>& a, double c_b,
                           const std::vector<Vec3>& b) {
  std::vector<Vec3> e(a.size());
  for (std::size_t i = 0; i < e.size(); ++i) e[i] = c_a * a[i] + c_b * b[i];
  return e;
}

}  // namespace

std::vector<Vec3> one_stage_error(const IntegratorSpec& integrator, double h,
                                  const std::vector<Vec3>& acceleration,
                                  const std::vector<Vec3>& change) {
  if (integrator.method == Method::implicit_euler) return combined(0.5 * h, change, 0.0, change);
  if (integrator.method != Method::generalised_alpha)
    return combined(h / 6.0, change, -h * h / 6.0, acceleration);
  // a1 - a0 = (change / h - a0) / gamma.
  const GeneralisedAlpha a = generalised_alpha(integrator.rho);
  const double c = (a.beta - 0.5 * a.gamma + 1.0 / 12.0) / a.gamma;
  return combined(c * h, change, -c * h * h, acceleration);
}

std::vector<Vec3> two_stage_error(double h, const std::vector<Vec3>& first,
                                  const std::vector<Vec3>& second) {
  constexpr double g = tr_bdf2::kGamma;
  constexpr double k = (-3.0 * g * g + 4.0 * g - 2.0) / (12.0 * (2.0 - g));
  // Velocities relative to the start's: `first` at gamma h, `first` + `second` at h.
  const double weight = 2.0 * k * h / (1.0 - g);
  return combined(weight * (1.0 - 1.0 / g), first, weight, second);
}

int local_order(Method method) { return method == Method::implicit_euler ? 2 : 3; }

double most_growth(const IntegratorSpec& integrator) {
  if (integrator.method != Method::generalised_alpha) return kMostGrowth;
  const double alpha_m = generalised_alpha(integrator.rho).alpha_m;
  if (alpha_m == 0.0) return kMostGrowth;
  const double kept = std::abs(alpha_m) / (1.0 - alpha_m);
  return std::clamp(0.98 / std::sqrt(kept), kLeastGrowth, kMostGrowth);
}

double fitting_step(double h, double ratio, int order, double growth) {
  if (ratio <= 0.0) return growth * h;
  return h * std::clamp(kSafety * std::pow(ratio, -1.0 / order), kMostShrinkage, growth);
}

bool at_kink(double before, double ratio_before, double h, double ratio, int order) {
  return ratio > ratio_before * std::pow(h / before, 0.5 * order);
}

double part_of(double remaining, double wanted) {
  if (remaining <= 1.0001 * wanted) return remaining;
  return remaining < 2.0 * wanted ? 0.5 * remaining : wanted;
}

}  // namespace retiarius
