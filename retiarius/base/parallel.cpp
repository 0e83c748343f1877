#include "retiarius/base/parallel.hpp"

#include <algorithm>
#include <memory>
#include <vector>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

namespace retiarius {

namespace {
int thread_count = 1;
std::unique_ptr<tbb::global_control> control;
}  // namespace

void set_threads(int count) {
  thread_count = std::max(1, count);
  control = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                  static_cast<std::size_t>(thread_count));
}

int threads() { return thread_count; }

void run_ranges(std::size_t count, std::size_t grain,
                const std::function<void(std::size_t, std::size_t)>& body) {
  const std::size_t ranges = (count + grain - 1) / grain;
  const auto run = [&](std::size_t k) { body(k * grain, std::min(count, (k + 1) * grain)); };
  if (thread_count == 1 || ranges <= 1) {
    for (std::size_t k = 0; k < ranges; ++k) run(k);
  } else {
    tbb::parallel_for(std::size_t{0}, ranges, run);
  }
}

double sum_ranges(std::size_t count, std::size_t grain,
                  const std::function<double(std::size_t, std::size_t)>& body) {
  constexpr std::size_t kFew = 64;  // ranges whose sums need no memory
  double few[kFew];
  std::vector<double> many;
  const std::size_t ranges = (count + grain - 1) / grain;
  double* parts = few;
  if (ranges > kFew) {
    many.resize(ranges);
    parts = many.data();
  }
  parallel_for(count, grain, [&](std::size_t begin, std::size_t end) {
    parts[begin / grain] = body(begin, end);
  });
  double sum = 0.0;
  for (std::size_t k = 0; k < ranges; ++k) sum += parts[k];
  return sum;
}

}  // namespace retiarius
