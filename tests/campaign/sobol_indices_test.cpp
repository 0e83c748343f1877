#include "retiarius/campaign/sobol_indices.hpp"

#include <cmath>
#include <functional>
#include <utility>

#include <gtest/gtest.h>

#include "retiarius/base/error.hpp"
#include "retiarius/base/random.hpp"
#include "retiarius/base/vec.hpp"

namespace retiarius {
namespace {

using Function = std::function<double(const std::vector<double>&)>;

// Results in Saltelli's order, with inputs uniform in 0 to 1.
std::vector<double> saltelli_runs(const Function& f, std::size_t k, std::size_t blocks,
                                  std::uint64_t seed) {
  std::vector<double> values;
  for (std::size_t block = 0; block < blocks; ++block) {
    std::vector<double> a, b;
    for (std::size_t i = 0; i < k; ++i) {
      a.push_back(random_uniform(seed, block, i));
      b.push_back(random_uniform(seed, block, k + i));
    }
    values.push_back(f(a));
    values.push_back(f(b));
    for (std::size_t i = 0; i < k; ++i) {
      std::vector<double> mixed = a;
      mixed[i] = b[i];
      values.push_back(f(mixed));
    }
  }
  return values;
}

// Ishigami and Homma (1990): sin x1 + 7 sin^2 x2 + 0.1 x3^4 sin x1, each x uniform in -pi to pi.
double ishigami(const std::vector<double>& u) {
  const double x1 = kPi * (2 * u[0] - 1), x2 = kPi * (2 * u[1] - 1), x3 = kPi * (2 * u[2] - 1);
  return std::sin(x1) + 7 * std::pow(std::sin(x2), 2) + 0.1 * std::pow(x3, 4) * std::sin(x1);
}

struct Exact {
  double mean, variance, first[3], total[3];
};

Exact ishigami_exact() {
  const double a = 7, b = 0.1, pi4 = std::pow(kPi, 4), pi8 = pi4 * pi4;
  const double v1 = 0.5 * std::pow(1 + b * pi4 / 5, 2), v2 = a * a / 8;
  const double v13 = b * b * pi8 * (1.0 / 18 - 1.0 / 50), v = v1 + v2 + v13;
  return {a / 2, v, {v1 / v, v2 / v, 0}, {(v1 + v13) / v, v2 / v, v13 / v}};
}

// One study misses each of its six 95 % intervals once in twenty; a hundred studies tell whether
// they cover, and whether the estimates are right on average.
TEST(SobolIndices, OfTheIshigamiFunctionLieInTheirIntervals) {
  constexpr int kStudies = 100;
  const Exact exact = ishigami_exact();
  int covered[6] = {};
  double mean[6] = {}, square[6] = {};
  for (std::uint64_t study = 0; study < kStudies; ++study) {
    const auto found = sobol_indices(saltelli_runs(ishigami, 3, 1024, study), 3, {300, 0.95, 1});
    EXPECT_EQ(found.blocks, 1024u);
    EXPECT_NEAR(found.mean, exact.mean, 0.5);
    EXPECT_NEAR(found.variance, exact.variance, 2.0);
    for (std::size_t i = 0; i < 3; ++i) {
      const SobolIndex& s = found.inputs[i];
      covered[2 * i] += s.first_interval.contains(exact.first[i]) ? 1 : 0;
      covered[2 * i + 1] += s.total_interval.contains(exact.total[i]) ? 1 : 0;
      for (auto [k, error] : {std::pair{2 * i, s.first - exact.first[i]},
                              std::pair{2 * i + 1, s.total - exact.total[i]}}) {
        mean[k] += error / kStudies;
        square[k] += error * error / kStudies;
      }
      EXPECT_TRUE(s.first_interval.contains(s.first));
      EXPECT_TRUE(s.total_interval.contains(s.total));
    }
  }
  for (std::size_t k = 0; k < 6; ++k) {  // four standard deviations
    EXPECT_NEAR(covered[k], 0.95 * kStudies, 4 * std::sqrt(kStudies * 0.95 * 0.05)) << k;
    EXPECT_NEAR(mean[k], 0.0, 4 * std::sqrt(square[k] / kStudies)) << k;
  }
}

// The error falls as one over the root of the number of blocks.
TEST(SobolIndices, Converge) {
  const Exact exact = ishigami_exact();
  const auto error = [&](std::size_t blocks) {
    double sum = 0.0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const auto found = sobol_indices(saltelli_runs(ishigami, 3, blocks, seed), 3, {2, 0.95, 1});
      for (std::size_t i = 0; i < 3; ++i)
        sum += std::pow(found.inputs[i].first - exact.first[i], 2) +
               std::pow(found.inputs[i].total - exact.total[i], 2);
    }
    return std::sqrt(sum);
  };
  const double ratio = error(256) / error(4096);
  EXPECT_GT(ratio, 3.0);
  EXPECT_LT(ratio, 5.3);
}

// 3 u0 + u1 with first and total indices 0.9 and 0.1.
TEST(SobolIndices, BootstrapIntervalsCoverAsTheySay) {
  constexpr int kRepetitions = 200;
  const Function f = [](const std::vector<double>& u) { return 3 * u[0] + u[1] + 1000.0; };
  int first[2] = {}, total[2] = {};
  for (std::uint64_t r = 0; r < kRepetitions; ++r) {
    const auto found = sobol_indices(saltelli_runs(f, 2, 400, 1000 + r), 2, {400, 0.95, r});
    const double exact[2] = {0.9, 0.1};
    for (std::size_t i = 0; i < 2; ++i) {
      first[i] += found.inputs[i].first_interval.contains(exact[i]) ? 1 : 0;
      total[i] += found.inputs[i].total_interval.contains(exact[i]) ? 1 : 0;
    }
  }
  // Four standard deviations of the count about 95 %.
  const double allowed = 4 * std::sqrt(kRepetitions * 0.95 * 0.05);
  for (int i : {0, 1}) {
    EXPECT_NEAR(first[i], 0.95 * kRepetitions, allowed);
    EXPECT_NEAR(total[i], 0.95 * kRepetitions, allowed);
  }
}

TEST(SobolIndices, OfAProductTellInteraction) {
  // (u0 - 1/2)(u1 - 1/2): no first-order effect, all of it together.
  const Function f = [](const std::vector<double>& u) { return (u[0] - 0.5) * (u[1] - 0.5); };
  const SobolIndices found = sobol_indices(saltelli_runs(f, 2, 4096, 2), 2);
  for (const SobolIndex& s : found.inputs) {
    EXPECT_TRUE(s.first_interval.contains(0.0));
    EXPECT_NEAR(s.first, 0.0, 0.05);
    EXPECT_TRUE(s.total_interval.contains(1.0));
  }
}

TEST(SobolIndices, DropWholeBlocksAndCountThem) {
  const Function f = [](const std::vector<double>& u) { return u[0]; };
  std::vector<double> values = saltelli_runs(f, 1, 50, 9);
  const SobolIndices whole = sobol_indices(saltelli_runs(f, 1, 49, 9), 1);
  values[49 * 3 + 2] = NAN;  // a missing value
  values.push_back(0.5);     // a block of one row
  const SobolIndices found = sobol_indices(values, 1);
  EXPECT_EQ(found.blocks, 49u);
  EXPECT_EQ(found.dropped, 2u);
  EXPECT_EQ(found.inputs[0].first, whole.inputs[0].first);
  EXPECT_EQ(found.inputs[0].total_interval.low, whole.inputs[0].total_interval.low);
}

TEST(SobolIndices, OfAConstantAreUndefined) {
  const SobolIndices found = sobol_indices(std::vector<double>(30, 2.0), 1);
  EXPECT_EQ(found.variance, 0.0);
  EXPECT_TRUE(std::isnan(found.inputs[0].first));
  EXPECT_TRUE(std::isnan(sobol_indices({1, 2, 3}, 1).inputs[0].total));
  EXPECT_THROW(sobol_indices({1, 2}, 0), Error);
  EXPECT_THROW(sobol_indices({1, 2}, 1, {1, 0.95, 1}), Error);
}

TEST(SobolIndices, DoNotDependOnALargeMean) {
  const Function f = [](const std::vector<double>& u) { return 3 * u[0] + u[1]; };
  const Function shifted = [&](const std::vector<double>& u) { return f(u) + 1e6; };
  const auto a = sobol_indices(saltelli_runs(f, 2, 200, 4), 2);
  const auto b = sobol_indices(saltelli_runs(shifted, 2, 200, 4), 2);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(a.inputs[i].first, b.inputs[i].first, 1e-8);
    EXPECT_NEAR(a.inputs[i].total, b.inputs[i].total, 1e-8);
    EXPECT_NEAR(a.inputs[i].first_interval.low, b.inputs[i].first_interval.low, 1e-8);
  }
}

}  // namespace
}  // namespace retiarius
