#include "retiarius/campaign/stop_rule.hpp"

#include <algorithm>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "retiarius/base/random.hpp"
#include "retiarius/campaign/run_queue.hpp"
#include "retiarius/campaign/statistics.hpp"

namespace retiarius {
namespace {

StopSpec spec() { return {.width = 0.2, .confidence = 0.95, .batch = 20}; }

// A run succeeds in seven of ten cases; every 13th gives no answer.
RunState outcome(std::int64_t id) {
  if (id % 13 == 5) return kNoAnswer;
  return random_uniform(1, 2, static_cast<std::uint64_t>(id)) < 0.7 ? kSuccess : kNoSuccess;
}

// By hand: the first multiple of the batch at which the interval is narrow enough.
std::int64_t expected_end(std::int64_t runs) {
  std::int64_t successes = 0, answers = 0;
  for (std::int64_t id = 0; id < runs; ++id) {
    if (outcome(id) != kNoAnswer) ++answers;
    if (outcome(id) == kSuccess) ++successes;
    if ((id + 1) % 20 == 0 && wilson_interval(successes, answers).width() < 0.2) return id + 1;
  }
  return runs;
}

TEST(StopRule, DecidesTheSameInWhateverOrderRunsEnd) {
  ASSERT_LT(expected_end(400), 200);
  ASSERT_GT(expected_end(400), 40);
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::vector<std::int64_t> order(400);
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), std::mt19937(seed));
    StopRule rule(spec(), 400);
    std::vector<std::uint8_t> states(400, kNotDone);
    for (const std::int64_t id : order) {
      states[static_cast<std::size_t>(id)] = outcome(id);
      rule.update(states);
    }
    EXPECT_EQ(rule.end(), expected_end(400));
    EXPECT_TRUE(rule.stopped());
  }
}

TEST(StopRule, NeverStopsWithoutWidth) {
  StopRule rule({}, 1000);
  rule.update(std::vector<std::uint8_t>(1000, kSuccess));
  EXPECT_FALSE(rule.stopped());
  EXPECT_EQ(rule.end(), 1000);
  EXPECT_EQ(rule.horizon(), 1000);
}

// Several workers that take and finish runs at random: nobody begins a run far beyond the decision,
// and all that counts gets done.
TEST(RunQueue, HandsOutWhatIsMissingUntilTheRuleStops) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    std::vector<std::uint8_t> states(400, kNotDone);
    states[3] = outcome(3);
    RunQueue queue(spec(), states, 0, 400);
    std::vector<std::int64_t> under_way;
    std::int64_t last = -1, begun = 0;
    while (!queue.finished()) {
      if (under_way.size() < 4) {
        if (const auto id = queue.next()) {
          EXPECT_GT(*id, last);
          EXPECT_NE(*id, 3);
          last = *id;
          ++begun;
          under_way.push_back(*id);
          continue;
        }
      }
      ASSERT_FALSE(under_way.empty());
      const std::size_t pick = random() % under_way.size();
      queue.done(under_way[pick], outcome(under_way[pick]));
      under_way.erase(under_way.begin() + static_cast<std::ptrdiff_t>(pick));
    }
    EXPECT_EQ(queue.rule().end(), expected_end(400));
    EXPECT_LE(last, expected_end(400) + 2 * 20);
    for (std::int64_t id = 0; id < queue.rule().end(); ++id)
      EXPECT_NE(queue.states()[static_cast<std::size_t>(id)], kNotDone);
    EXPECT_GE(begun, queue.rule().end() - 1);
  }
}

TEST(RunQueue, KeepsToItsRange) {
  RunQueue queue({}, std::vector<std::uint8_t>(10, kNotDone), 4, 6);
  EXPECT_EQ(queue.next(), 4);
  EXPECT_EQ(queue.next(), 5);
  EXPECT_EQ(queue.next(), std::nullopt);
  EXPECT_FALSE(queue.finished());
  queue.done(4, kSuccess);
  queue.done(5, kNoAnswer);
  EXPECT_TRUE(queue.finished());
  EXPECT_EQ(queue.count_done(), 2);
  EXPECT_EQ(queue.to_do(), 2);
}

}  // namespace
}  // namespace retiarius
