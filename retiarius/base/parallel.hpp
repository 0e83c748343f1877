// Parallel loops whose result does not depend on the number of threads.
#pragma once

#include <cstddef>
#include <functional>

namespace retiarius {

// Sets the number of threads that loops may use, from now on, in the whole process; at least 1.
void set_threads(int count);

// The number of threads that loops may use.
int threads();

// What the templates below call; a reference in a std::function needs no memory of its own.
void run_ranges(std::size_t count, std::size_t grain,
                const std::function<void(std::size_t, std::size_t)>& body);
double sum_ranges(std::size_t count, std::size_t grain,
                  const std::function<double(std::size_t, std::size_t)>& body);

// Calls body(begin, end) over disjoint ranges that cover [0, count). Ranges have `grain` elements
// (the last may have fewer) whatever the number of threads, so a body that writes only to its own
// range gives the same result bit for bit with any number of threads.
template <class Body>
void parallel_for(std::size_t count, std::size_t grain, const Body& body) {
  run_ranges(count, grain, std::ref(body));
}

// Sum over [0, count) of the values that body returns for ranges of `grain` elements, added in
// order of the ranges, so that rounding does not depend on the number of threads.
template <class Body>
double parallel_sum(std::size_t count, std::size_t grain, const Body& body) {
  return sum_ranges(count, grain, std::ref(body));
}

}  // namespace retiarius
