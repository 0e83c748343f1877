// Measures the time of parts of the work. What it measures never steers anything.
#pragma once

#include <chrono>

namespace retiarius {

// Adds the wall time of its own life to a sum, s.
class Stopwatch {
 public:
  explicit Stopwatch(double& sum) : sum_(sum) {}
  ~Stopwatch() {
    const std::chrono::duration<double> lived = std::chrono::steady_clock::now() - start_;
    sum_ += lived.count();
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& sum_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace retiarius
