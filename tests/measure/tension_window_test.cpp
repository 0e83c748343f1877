#include "retiarius/measure/tension_window.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace retiarius {
namespace {

struct Sample {
  double h;
  std::vector<double> tension;
};

// Mean of one segment over the window that ends with sample `last`.
double mean(const std::vector<Sample>& run, std::size_t last, std::size_t segment, double width) {
  double left = width, integral = 0.0;
  for (std::size_t k = last + 1; k-- > 0 && left > 0.0;) {
    const double h = std::min(left, run[k].h);
    integral += h * run[k].tension[segment];
    left -= h;
  }
  return integral / width;
}

double largest_mean(const std::vector<Sample>& run, double width) {
  double best = -1e300, time = 0.0;
  for (std::size_t k = 0; k < run.size(); ++k) {
    time += run[k].h;
    if (time < width * (1.0 - 1e-9)) continue;
    for (std::size_t s = 0; s < run[k].tension.size(); ++s)
      best = std::max(best, mean(run, k, s, width));
  }
  return best;
}

std::vector<Sample> random_run(int steps, double shortest, double longest) {
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> h(shortest, longest), t(-50.0, 300.0);
  std::vector<Sample> run;
  for (int k = 0; k < steps; ++k) {
    Sample s{h(engine), {}};
    for (int i = 0; i < 5; ++i) s.tension.push_back(t(engine));
    run.push_back(s);
  }
  return run;
}

double measured(const std::vector<Sample>& run) {
  TensionWindow window;
  for (const Sample& s : run) window.add(s.h, s.tension);
  return *window.largest();
}

TEST(TensionWindow, AgreesWithBruteForce) {
  for (const auto& [shortest, longest] :
       {std::pair{1e-3, 1e-3}, {1e-4, 5e-3}, {5e-3, 5e-2}, {0.03, 0.05}}) {
    const std::vector<Sample> run = random_run(2000, shortest, longest);
    EXPECT_NEAR(measured(run), largest_mean(run, 0.02), 1e-9) << shortest;
  }
}

// Steps too short to be kept one by one: only the group at the window's edge is approximate.
TEST(TensionWindow, GroupsShortSteps) {
  std::vector<Sample> run;
  double time = 0.0;
  for (int k = 0; k < 40000; ++k) {
    time += 2e-6;
    run.push_back({2e-6, {100.0 * std::sin(40.0 * time), 1.0}});
  }
  // Mean of a sine around its top: sin(w T/2) / (w T/2) of the top.
  EXPECT_NEAR(measured(run), 100.0 * std::sin(0.4) / 0.4, 1e-3);
}

TEST(TensionWindow, SeesASnapAtItsMean) {
  std::vector<Sample> run(100, Sample{1e-3, {10.0}});
  run[50].tension[0] = 1010.0;
  EXPECT_NEAR(measured(run), 10.0 + 1000.0 / 20.0, 1e-10);
}

TEST(TensionWindow, DoesNotMixSegments) {
  std::vector<Sample> run;
  for (int k = 0; k < 100; ++k)
    run.push_back({1e-2, {k % 2 == 0 ? 100.0 : 0.0, k % 2 == 0 ? 0.0 : 100.0}});
  EXPECT_NEAR(measured(run), 50.0, 1e-12);
}

TEST(TensionWindow, StartsOnlyWithAWholeWindow) {
  TensionWindow window;
  EXPECT_FALSE(window.largest().has_value());
  window.add(0.001, {500.0});
  window.add(0.009, {0.0});
  EXPECT_NEAR(*window.largest(), 50.0, 1e-12) << "the whole run is shorter than a window";
  window.add(0.010, {0.0});
  EXPECT_NEAR(*window.largest(), 25.0, 1e-12);
  window.clear();
  EXPECT_FALSE(window.largest().has_value());
}

TEST(TensionWindow, CanBeNegative) {
  EXPECT_NEAR(measured(std::vector<Sample>(30, Sample{1e-3, {-4.0, -9.0}})), -4.0, 1e-12);
}

TEST(TensionWindow, LongStepCountsAsItIs) {
  EXPECT_NEAR(measured({{0.05, {3.0}}, {0.05, {8.0}}, {0.05, {5.0}}}), 8.0, 1e-12);
}

}  // namespace
}  // namespace retiarius
