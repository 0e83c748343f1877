// What a case yields: comparisons with references, and charts.
#pragma once

#include <string>
#include <vector>

#include "retiarius/report/chart.hpp"

namespace retiarius::verification {

enum class ErrorKind { relative, absolute };

struct Comparison {
  std::string quantity;    // "tip deflection at beta = 4"
  std::string unit = "1";  // "1": none
  double ours = 0.0, reference = 0.0;
  ErrorKind kind = ErrorKind::relative;
  double bound = 0.0;    // largest error that passes, in the kind's terms
  std::string source;    // of the reference
  std::string argument;  // why the bound is what it is

  double error() const;  // |ours - reference|, relative: over |reference|
  bool passes() const;   // false for what is not finite
};

struct CaseResult {
  std::vector<Comparison> comparisons;
  std::vector<Chart> charts;
  std::vector<std::string> notes;  // paragraphs: what was learned, what no number says
  std::string failure;             // why the case broke off; empty: it did not
  double wall_time = 0.0;          // s

  bool passes() const;
};

}  // namespace retiarius::verification
