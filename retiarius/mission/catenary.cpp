#include "retiarius/mission/catenary.hpp"

#include <cmath>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"

namespace retiarius {

namespace {

Catenary from_parameter(double u) {
  Catenary c;
  c.parameter = u;
  c.span_ratio = u > 0.0 ? u / std::sinh(u) : 1.0;
  c.sag_ratio = 0.5 * std::tanh(0.5 * u);
  c.horizontal = u > 0.0 ? 0.5 / std::sinh(u) : kInfinity;
  c.end_tension = u > 0.0 ? 0.5 / std::tanh(u) : kInfinity;
  return c;
}

}  // namespace

Catenary catenary_from_span(double span_ratio) {
  if (!(span_ratio > 0.0) || span_ratio > 1.0)
    throw Error(fmt::format("catenary: span ratio {} is outside (0, 1]", span_ratio));
  if (span_ratio == 1.0) return from_parameter(0.0);
  // u / sinh u falls monotonically; the bracket grows until it holds the root.
  double low = 0.0;
  double high = 1.0;
  while (high / std::sinh(high) > span_ratio) high *= 2.0;
  for (int k = 0; k < 200 && high - low > 1e-16 * high; ++k) {
    const double middle = 0.5 * (low + high);
    (middle / std::sinh(middle) > span_ratio ? low : high) = middle;
  }
  Catenary c = from_parameter(0.5 * (low + high));
  c.span_ratio = span_ratio;
  return c;
}

Catenary catenary_from_sag(double sag_ratio) {
  if (!(sag_ratio >= 0.0) || sag_ratio >= 0.5)
    throw Error(fmt::format("catenary: sag ratio {} is outside [0, 1/2)", sag_ratio));
  return from_parameter(2.0 * std::atanh(2.0 * sag_ratio));
}

CatenaryPoint catenary_point(const Catenary& c, double s) {
  const double u = c.parameter;
  if (u == 0.0) return {s, 0.0};
  const double a = 0.5 / std::sinh(u);  // over L
  const double arc = s - 0.5;           // from the lowest point, over L
  return {a * (u + std::asinh(arc / a)), a * (std::cosh(u) - std::hypot(1.0, arc / a))};
}

}  // namespace retiarius
