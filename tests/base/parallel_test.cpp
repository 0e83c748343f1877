#include "retiarius/base/parallel.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace retiarius {
namespace {

// Runs each test with one thread again afterwards.
class Parallel : public ::testing::Test {
 protected:
  void TearDown() override { set_threads(1); }
};

TEST_F(Parallel, VisitsEveryElementOnce) {
  for (int count : {1, 2, 4}) {
    set_threads(count);
    EXPECT_EQ(threads(), count);
    std::vector<int> visits(1003, 0);
    parallel_for(visits.size(), 10, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) ++visits[i];
    });
    EXPECT_EQ(visits, std::vector<int>(1003, 1));
  }
}

TEST_F(Parallel, NothingToDoCallsNothing) {
  parallel_for(0, 10, [](std::size_t, std::size_t) { FAIL(); });
  EXPECT_EQ(parallel_sum(0, 10, [](std::size_t, std::size_t) { return 1.0; }), 0.0);
}

TEST_F(Parallel, AtLeastOneThread) {
  set_threads(0);
  EXPECT_EQ(threads(), 1);
}

// Terms of very different size: a sum in another order would round differently.
TEST_F(Parallel, SumIsTheSameBitForBitWithAnyNumberOfThreads) {
  const auto term = [](std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
      sum += std::sin(static_cast<double>(i)) * std::pow(10.0, static_cast<double>(i % 17));
    }
    return sum;
  };
  const double alone = parallel_sum(100000, 64, term);
  for (int count : {2, 4}) {
    set_threads(count);
    EXPECT_EQ(parallel_sum(100000, 64, term), alone);
  }
}

}  // namespace
}  // namespace retiarius
