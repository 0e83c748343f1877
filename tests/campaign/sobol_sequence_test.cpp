#include "retiarius/campaign/sobol_sequence.hpp"

#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "retiarius/campaign/sobol_numbers.hpp"

namespace retiarius {
namespace {

TEST(SobolSequence, PolynomialsArePrimitive) {
  EXPECT_TRUE(is_primitive(0b11));      // x + 1
  EXPECT_TRUE(is_primitive(0b111));     // x2 + x + 1
  EXPECT_TRUE(is_primitive(0b1011));    // x3 + x + 1
  EXPECT_TRUE(is_primitive(0b10011));   // x4 + x + 1
  EXPECT_FALSE(is_primitive(0b11111));  // irreducible, of order 5
  EXPECT_FALSE(is_primitive(0b101));    // (x + 1)^2
  EXPECT_FALSE(is_primitive(0b110));    // x (x + 1)
  // phi(2^s - 1)/s of degree s.
  const int expected[] = {1, 1, 2, 2, 6, 6, 18, 16, 48};
  for (int s = 1; s <= 9; ++s) {
    int count = 0;
    for (std::uint32_t p = 1u << s; p < 2u << s; ++p)
      if (is_primitive(p)) ++count;
    EXPECT_EQ(count, expected[s - 1]) << s;
  }
}

TEST(SobolSequence, InitialNumbersAreOddAndSmall) {
  for (const SobolNumbers& numbers : kSobolNumbers) {
    for (std::size_t i = 0; i < numbers.size() && numbers[i] != 0; ++i) {
      EXPECT_EQ(numbers[i] % 2, 1u);
      EXPECT_LT(numbers[i], 2u << i);
    }
  }
}

TEST(SobolSequence, FirstCoordinateIsVanDerCorputs) {
  const SobolSequence s;
  const double expected[] = {0.0, 0.5, 0.25, 0.75, 0.125, 0.625, 0.375, 0.875};
  for (std::uint64_t i = 0; i < 8; ++i) EXPECT_EQ(s.digits(i, 0) * 0x1.0p-32, expected[i]);
}

// Every dimension alone: of any 2^m points one lies in each of 2^m equal pieces, scrambled or not.
TEST(SobolSequence, EveryDimensionIsStratified) {
  const SobolSequence s;
  constexpr std::uint64_t kPoints = 1024;
  for (int d = 0; d < SobolSequence::kDimensions; ++d) {
    std::set<int> plain, scrambled;
    for (std::uint64_t i = kPoints; i < 2 * kPoints; ++i) {
      plain.insert(static_cast<int>(s.digits(i, d) * 0x1.0p-32 * kPoints));
      scrambled.insert(static_cast<int>(s.scrambled(i, d, 9) * kPoints));
    }
    EXPECT_EQ(plain.size(), kPoints) << d;
    EXPECT_EQ(scrambled.size(), kPoints) << d;
  }
}

// The first two dimensions are a (0, m, 2)-net: every elementary box of 2^-m has one of 2^m points.
TEST(SobolSequence, FirstPairFillsElementaryBoxesAlsoWhenScrambled) {
  const SobolSequence s;
  constexpr int kM = 8;
  for (int q = 0; q <= kM; ++q) {
    std::set<std::pair<int, int>> boxes;
    for (std::uint64_t i = 0; i < 1u << kM; ++i)
      boxes.insert({static_cast<int>(std::ldexp(s.scrambled(i, 0, 4), q)),
                    static_cast<int>(std::ldexp(s.scrambled(i, 1, 4), kM - q))});
    EXPECT_EQ(boxes.size(), 1u << kM) << q;
  }
}

// Even points gain less the more dimensions a thousand of them must fill.
// Warnock's L2 star discrepancy of the scrambled points against what random points have on average,
// sqrt((2^-d - 3^-d) / n).
double discrepancy(int dimensions, int n) {
  const SobolSequence s;
  std::vector<std::vector<double>> x(static_cast<std::size_t>(n));
  for (std::size_t i = 0; i < x.size(); ++i)
    for (int d = 0; d < dimensions; ++d) x[i].push_back(s.scrambled(i, d, 1));
  double single = 0.0, pairs = 0.0;
  for (const auto& p : x) {
    double product = 1.0;
    for (const double c : p) product *= 0.5 * (1.0 - c * c);
    single += product;
    for (const auto& q : x) {
      double both = 1.0;
      for (std::size_t d = 0; d < p.size(); ++d) both *= 1.0 - std::max(p[d], q[d]);
      pairs += both;
    }
  }
  return std::sqrt(std::pow(3.0, -dimensions) - 2.0 / n * single + pairs / n / n);
}

TEST(SobolSequence, DiscrepancyIsFarBelowThatOfRandomPoints) {
  for (const int d : {2, 5, 8}) {
    const int n = 1024;
    const double random = std::sqrt((std::pow(2.0, -d) - std::pow(3.0, -d)) / n);
    EXPECT_LT(discrepancy(d, n), (d == 2 ? 0.1 : d == 5 ? 0.5 : 0.75) * random) << d;
  }
}

// Each scrambling is a sample of its own: the points' mean varies about one half, unbiased.
TEST(SobolSequence, ScramblingIsUnbiased) {
  const SobolSequence s;
  double mean = 0.0;
  constexpr int kSeeds = 4000;
  for (int seed = 0; seed < kSeeds; ++seed)
    mean += s.scrambled(3, 5, static_cast<std::uint64_t>(seed)) / kSeeds;
  EXPECT_NEAR(mean, 0.5, 4.0 * std::sqrt(1.0 / 12.0 / kSeeds));
}

}  // namespace
}  // namespace retiarius
