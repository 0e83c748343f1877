#include "retiarius/campaign/statistics_rank.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "retiarius/base/error.hpp"

namespace retiarius {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// Continued fraction of the incomplete beta function by Lentz's method.
double beta_fraction(double a, double b, double x) {
  constexpr double kTiny = 1e-300;
  const auto guarded = [](double v) { return std::abs(v) < kTiny ? kTiny : v; };
  double c = 1.0;
  double d = 1.0 / guarded(1.0 - (a + b) * x / (a + 1.0));
  double value = d;
  for (int m = 1; m < 10000; ++m) {
    const double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
    d = 1.0 / guarded(1.0 + even * d);
    c = guarded(1.0 + even / c);
    value *= d * c;
    const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
    d = 1.0 / guarded(1.0 + odd * d);
    c = guarded(1.0 + odd / c);
    value *= d * c;
    if (std::abs(d * c - 1.0) < 1e-15) break;
  }
  return value;
}

// Pearson's correlation.
double correlation(const std::vector<double>& x, const std::vector<double>& y) {
  const double n = static_cast<double>(x.size());
  const double mx = std::accumulate(x.begin(), x.end(), 0.0) / n;
  const double my = std::accumulate(y.begin(), y.end(), 0.0) / n;
  double xx = 0.0, yy = 0.0, xy = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    xx += (x[k] - mx) * (x[k] - mx);
    yy += (y[k] - my) * (y[k] - my);
    xy += (x[k] - mx) * (y[k] - my);
  }
  if (xx == 0.0 || yy == 0.0) return kNan;
  return std::clamp(xy / std::sqrt(xx * yy), -1.0, 1.0);
}

}  // namespace

double incomplete_beta(double a, double b, double x) {
  if (x <= 0.0) return 0.0;
  if (x >= 1.0) return 1.0;
  const double front = std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) +
                                a * std::log(x) + b * std::log1p(-x));
  // The fraction converges quickly below the mean; above, the other tail is taken.
  if (x < (a + 1.0) / (a + b + 2.0)) return front * beta_fraction(a, b, x) / a;
  return 1.0 - front * beta_fraction(b, a, 1.0 - x) / b;
}

std::vector<double> ranks(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> result(values.size());
  for (std::size_t first = 0; first < order.size();) {
    std::size_t end = first + 1;
    while (end < order.size() && values[order[end]] == values[order[first]]) ++end;
    for (std::size_t k = first; k < end; ++k)
      result[order[k]] = 0.5 * static_cast<double>(first + 1 + end);
    first = end;
  }
  return result;
}

RankCorrelation rank_correlation(const std::vector<double>& x, const std::vector<double>& y,
                                 double confidence) {
  if (x.size() != y.size()) throw Error("a rank correlation needs as many x as y");
  std::vector<double> a, b;
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (std::isnan(x[k]) || std::isnan(y[k])) continue;
    a.push_back(x[k]);
    b.push_back(y[k]);
  }
  RankCorrelation result;
  result.count = a.size();
  result.rho = a.size() < 3 ? kNan : correlation(ranks(a), ranks(b));
  if (std::isnan(result.rho)) {
    result.p_value = kNan;
    return result;
  }
  const double n = static_cast<double>(a.size());
  // P(|t| > t0) = I_{v / (v + t0^2)}(v/2, 1/2) with t0^2 = v rho^2 / (1 - rho^2), v = n - 2.
  result.p_value = incomplete_beta(0.5 * (n - 2.0), 0.5, 1.0 - result.rho * result.rho);
  if (a.size() < 4) return result;
  const double z = normal_quantile(0.5 * (1.0 + confidence));
  const double half = z * std::sqrt((1.0 + 0.5 * result.rho * result.rho) / (n - 3.0));
  const double middle = std::atanh(result.rho);
  result.interval = {std::tanh(middle - half), std::tanh(middle + half)};
  return result;
}

}  // namespace retiarius
