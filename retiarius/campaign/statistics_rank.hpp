// Rank correlation: how far one quantity rises or falls with another, whatever the curve between.
#pragma once

#include <cstddef>
#include <vector>

#include "retiarius/campaign/statistics.hpp"

namespace retiarius {

// Ranks from 1; equal values share the mean of their ranks. No NaN.
std::vector<double> ranks(const std::vector<double>& values);

struct RankCorrelation {
  double rho = 0.0;              // Spearman's, -1 to 1; NaN where a quantity is constant or n < 3
  double p_value = 1.0;          // two-sided, of no correlation; NaN with rho
  Interval interval{-1.0, 1.0};  // of rho; all of -1 to 1 where n < 4
  std::size_t count = 0;         // pairs with both values
};

// Spearman's rank correlation (Pearson's of the ranks, right with ties). Pairs with a NaN are left
// out. p-value from Student's t with n - 2 degrees of freedom; the interval by Fisher's transform
// with the variance (1 + rho^2/2) / (n - 3) (Bonett & Wright, Psychometrika 65, 2000). Throws Error
// where x and y differ in length.
RankCorrelation rank_correlation(const std::vector<double>& x, const std::vector<double>& y,
                                 double confidence = 0.95);

// Regularised incomplete beta function I_x(a, b), by its continued fraction; 0 <= x <= 1.
double incomplete_beta(double a, double b, double x);

}  // namespace retiarius
