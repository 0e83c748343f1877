// Sobol indices: which share of a result's variance each input causes, alone and with others.
#pragma once

#include <cstdint>
#include <vector>

#include "retiarius/campaign/statistics.hpp"

namespace retiarius {

struct SobolIndex {
  double first = 0.0;  // caused by this input alone
  double total = 0.0;  // caused by it alone and together with others
  Interval first_interval, total_interval;
};

struct SobolIndices {
  std::vector<SobolIndex> inputs;     // NaN throughout where nothing varies or blocks < 2
  std::size_t blocks = 0;             // whole blocks, which were used
  std::size_t dropped = 0;            // blocks left out because a value is missing
  double mean = 0.0, variance = 0.0;  // of the result, over the rows of A and B
};

struct BootstrapOptions {
  int replicates = 1000;
  double confidence = 0.95;
  std::uint64_t seed = 1;
};

// From the results of runs in Saltelli's order: for k inputs run id = block (k + 2) + j, where
// j = 0 is a row of the matrix A, j = 1 the row of B, and j = 2 + i the row of A with its element i
// from B. `values` by run id; NaN is missing, and so is what the last block lacks.
//
// With f less its mean over A and B, and V its variance over both,
//   first_i = mean(f_B (f_ABi - f_A)) / V        Saltelli et al., Comput. Phys. Commun. 181, 2010
//   total_i = mean((f_A - f_ABi)^2) / (2 V)      Jansen, Comput. Phys. Commun. 117, 1999
// Intervals: percentiles of bootstrap replicates that draw whole blocks, by random numbers that
// depend on the seed alone. Estimates may fall a little outside of 0 to 1; they are given as found.
// Throws Error for k = 0, and for options that have no meaning.
SobolIndices sobol_indices(const std::vector<double>& values, std::size_t k,
                           const BootstrapOptions& options = {});

}  // namespace retiarius
