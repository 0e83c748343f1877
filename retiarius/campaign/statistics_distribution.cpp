#include "retiarius/campaign/statistics_distribution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace retiarius {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::vector<double> ascending_of(const std::vector<double>& values) {
  std::vector<double> sorted;
  for (double v : values)
    if (!std::isnan(v)) sorted.push_back(v);
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

// A bin about each of a few distinct values, divided halfway between them.
std::vector<double> edges_between(const std::vector<double>& distinct) {
  std::vector<double> edges = {distinct[0] - 0.5 * (distinct[1] - distinct[0])};
  for (std::size_t k = 1; k < distinct.size(); ++k)
    edges.push_back(distinct[k - 1] + 0.5 * (distinct[k] - distinct[k - 1]));
  const std::size_t last = distinct.size() - 1;
  edges.push_back(distinct[last] + 0.5 * (distinct[last] - distinct[last - 1]));
  return edges;
}

// At most this many distinct values get a bin each.
constexpr std::size_t kFewValues = 8;

std::size_t usual_bins(const std::vector<double>& sorted) {
  const double range = sorted.back() - sorted.front();
  const double width = 2.0 * (quantile(sorted, 0.75) - quantile(sorted, 0.25)) /
                       std::cbrt(static_cast<double>(sorted.size()));
  if (!(width > 0.0)) return 10;
  return static_cast<std::size_t>(std::clamp(std::ceil(range / width), 5.0, 40.0));
}

}  // namespace

double quantile(const std::vector<double>& ascending, double p) {
  if (ascending.empty()) return kNan;
  const double place = p * static_cast<double>(ascending.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  if (below + 1 >= ascending.size()) return ascending.back();
  const double share = place - static_cast<double>(below);
  return (1.0 - share) * ascending[below] + share * ascending[below + 1];
}

SampleDistribution distribution(const std::vector<double>& values) {
  const std::vector<double> sorted = ascending_of(values);
  SampleDistribution d;
  d.count = sorted.size();
  d.missing = values.size() - sorted.size();
  const double n = static_cast<double>(d.count);
  d.mean = d.deviation = d.least = d.greatest = kNan;
  if (!sorted.empty()) {
    d.least = sorted.front();
    d.greatest = sorted.back();
    // About the middle of the range, so that a small spread of large values keeps its digits.
    const double middle = 0.5 * d.least + 0.5 * d.greatest;
    double sum = 0.0;
    for (double v : sorted) sum += v - middle;
    d.mean = middle + sum / n;
    double squares = 0.0;
    for (double v : sorted) squares += (v - d.mean) * (v - d.mean);
    if (d.count > 1) d.deviation = std::sqrt(squares / (n - 1.0));
  }
  d.q05 = quantile(sorted, 0.05);
  d.q25 = quantile(sorted, 0.25);
  d.median = quantile(sorted, 0.5);
  d.q75 = quantile(sorted, 0.75);
  d.q95 = quantile(sorted, 0.95);
  return d;
}

std::size_t Histogram::bin(double value) const {
  if (edges.empty() || !(value >= edges.front() && value <= edges.back())) return edges.size();
  const auto above = std::upper_bound(edges.begin(), edges.end(), value);
  return std::min(static_cast<std::size_t>(above - edges.begin()) - 1, counts.size() - 1);
}

Histogram histogram(const std::vector<double>& values, std::size_t bins) {
  Histogram h;
  const std::vector<double> sorted = ascending_of(values);
  if (sorted.empty()) return h;
  std::vector<double> distinct = sorted;
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  const double low = sorted.front(), high = sorted.back();
  if (distinct.size() == 1) {
    const double half = low == 0.0 ? 0.5 : 0.05 * std::abs(low);
    h.edges = {low - half, low + half};
  } else if (distinct.size() <= kFewValues && (bins == 0 || distinct.size() <= bins)) {
    h.edges = edges_between(distinct);
  } else {
    const std::size_t count = bins > 0 ? bins : usual_bins(sorted);
    for (std::size_t k = 0; k < count; ++k)
      h.edges.push_back(low + (high - low) * static_cast<double>(k) / static_cast<double>(count));
    h.edges.push_back(high);
  }
  h.counts.assign(h.edges.size() - 1, 0);
  for (double v : sorted) ++h.counts[h.bin(v)];
  return h;
}

}  // namespace retiarius
