#include "retiarius/campaign/sobol_indices.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "retiarius/base/error.hpp"
#include "retiarius/base/random.hpp"
#include "retiarius/campaign/statistics_distribution.hpp"

namespace retiarius {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// What a block adds to the sums from which the indices follow. With f less its mean m,
// sum (f_B - m)(f_ABi - f_A) = sum f_B (f_ABi - f_A) - m sum (f_ABi - f_A).
struct Sums {
  explicit Sums(std::size_t k) : product(k), difference(k), square(k) {}

  double value = 0.0;              // f_A + f_B
  double value_square = 0.0;       // f_A^2 + f_B^2
  std::vector<double> product;     // f_B (f_ABi - f_A)
  std::vector<double> difference;  // f_ABi - f_A
  std::vector<double> square;      // (f_ABi - f_A)^2

  void clear() { *this = Sums(product.size()); }
  void add(const Sums& other) {
    value += other.value;
    value_square += other.value_square;
    for (std::size_t i = 0; i < product.size(); ++i) {
      product[i] += other.product[i];
      difference[i] += other.difference[i];
      square[i] += other.square[i];
    }
  }
};

Sums sums_of(const double* row, std::size_t k, double shift) {
  Sums s(k);
  const double a = row[0] - shift, b = row[1] - shift;
  s.value = a + b;
  s.value_square = a * a + b * b;
  for (std::size_t i = 0; i < k; ++i) {
    const double d = row[2 + i] - row[0];
    s.product[i] = b * d;
    s.difference[i] = d;
    s.square[i] = d * d;
  }
  return s;
}

struct Moments {
  double mean, variance;
};

Moments moments_of(const Sums& sums, double blocks) {
  const double mean = sums.value / (2.0 * blocks);
  const double squares = sums.value_square - 2.0 * blocks * mean * mean;
  return {mean, std::max(0.0, squares / (2.0 * blocks - 1.0))};
}

// First and total indices, one after the other for each input; NaN where nothing varies.
void estimate(const Sums& sums, double blocks, std::vector<double>& result) {
  const auto [mean, variance] = moments_of(sums, blocks);
  for (std::size_t i = 0; i < sums.product.size(); ++i) {
    const double first = (sums.product[i] - mean * sums.difference[i]) / blocks;
    result[2 * i] = variance > 0.0 ? first / variance : kNan;
    result[2 * i + 1] = variance > 0.0 ? 0.5 * sums.square[i] / blocks / variance : kNan;
  }
}

Interval percentiles(std::vector<double> values, double confidence) {
  values.erase(std::remove_if(values.begin(), values.end(), [](double v) { return std::isnan(v); }),
               values.end());
  std::sort(values.begin(), values.end());
  return {quantile(values, 0.5 * (1.0 - confidence)), quantile(values, 0.5 * (1.0 + confidence))};
}

// The intervals of `indices`, from replicates that draw as many blocks as there are.
void add_intervals(const std::vector<Sums>& blocks, const BootstrapOptions& options,
                   SobolIndices& indices) {
  const std::size_t n = blocks.size(), k = indices.inputs.size();
  std::vector<std::vector<double>> replicates(2 * k);
  std::vector<double> found(2 * k);
  Sums sums(k);
  for (int r = 0; r < options.replicates; ++r) {
    sums.clear();
    for (std::size_t j = 0; j < n; ++j) {
      const double u = random_uniform(options.seed, static_cast<std::uint64_t>(r), j);
      sums.add(blocks[std::min(n - 1, static_cast<std::size_t>(u * static_cast<double>(n)))]);
    }
    estimate(sums, static_cast<double>(n), found);
    for (std::size_t i = 0; i < 2 * k; ++i) replicates[i].push_back(found[i]);
  }
  for (std::size_t i = 0; i < k; ++i) {
    indices.inputs[i].first_interval =
        percentiles(std::move(replicates[2 * i]), options.confidence);
    indices.inputs[i].total_interval =
        percentiles(std::move(replicates[2 * i + 1]), options.confidence);
  }
}

// The whole blocks' values, one after another.
std::vector<double> whole_blocks(const std::vector<double>& values, std::size_t rows,
                                 SobolIndices& indices) {
  std::vector<double> kept;
  for (std::size_t start = 0; start < values.size(); start += rows) {
    const std::size_t end = start + rows;
    if (end > values.size() || std::any_of(values.begin() + static_cast<std::ptrdiff_t>(start),
                                           values.begin() + static_cast<std::ptrdiff_t>(end),
                                           [](double v) { return !std::isfinite(v); })) {
      ++indices.dropped;
      continue;
    }
    ++indices.blocks;
    kept.insert(kept.end(), values.begin() + static_cast<std::ptrdiff_t>(start),
                values.begin() + static_cast<std::ptrdiff_t>(end));
  }
  return kept;
}

}  // namespace

SobolIndices sobol_indices(const std::vector<double>& values, std::size_t k,
                           const BootstrapOptions& options) {
  if (k == 0) throw Error("Sobol indices need at least one input");
  if (options.replicates < 2 || !(options.confidence > 0.0 && options.confidence < 1.0))
    throw Error("a bootstrap needs two replicates or more and a confidence between 0 and 1");
  const std::size_t rows = k + 2;
  SobolIndices indices;
  const std::vector<double> kept = whole_blocks(values, rows, indices);
  indices.mean = indices.variance = kNan;
  indices.inputs.assign(k, {kNan, kNan, {kNan, kNan}, {kNan, kNan}});
  if (indices.blocks < 2) return indices;

  // About a value near the mean, so that a small variance of large values keeps its digits.
  double shift = 0.0;
  for (std::size_t j = 0; j < indices.blocks; ++j)
    shift += 0.5 * (kept[j * rows] + kept[j * rows + 1]) / static_cast<double>(indices.blocks);
  std::vector<Sums> blocks;
  Sums all(k);
  for (std::size_t j = 0; j < indices.blocks; ++j) {
    blocks.push_back(sums_of(&kept[j * rows], k, shift));
    all.add(blocks.back());
  }
  const auto [mean, variance] = moments_of(all, static_cast<double>(indices.blocks));
  indices.mean = shift + mean;
  indices.variance = variance;
  if (!(variance > 0.0)) return indices;
  std::vector<double> found(2 * k);
  estimate(all, static_cast<double>(indices.blocks), found);
  for (std::size_t i = 0; i < k; ++i) {
    indices.inputs[i].first = found[2 * i];
    indices.inputs[i].total = found[2 * i + 1];
  }
  add_intervals(blocks, options, indices);
  return indices;
}

}  // namespace retiarius
