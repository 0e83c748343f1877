// Runs missions into folders, interrupted and resumed at will, and compares what they leave.
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "retiarius/mission/mission.hpp"
#include "retiarius/mission/observer.hpp"

namespace retiarius::testing {

// How a stretch of a run comes to its end after so many steps of its own.
struct Break {
  enum class Kind { stopped, died };
  Kind kind = Kind::stopped;
  int steps = 0;
};

// Runs the mission into `folder`. Of the outcome where it died: `interrupted`.
RunReport run_into(const std::filesystem::path& folder, const Mission& mission,
                   const std::vector<Break>& breaks = {});

// Goes on with it until the next break, if there is one.
RunReport resume_in(const std::filesystem::path& folder, const Mission& mission,
                    const std::vector<Break>& breaks = {});

// Runs it with breaks, resumed after each of them. Returns how many of the breaks came about.
int run_with_breaks(const std::filesystem::path& folder, const Mission& mission,
                    const std::vector<Break>& breaks);

// Every file of both folders alike: bytes, and where timings or the order of writing differ, the
// content.
void expect_same_results(const std::filesystem::path& one, const std::filesystem::path& other);

// What a mission is changed to for one of many tests.
struct ResumeCase {
  const char* name;
  std::vector<std::string> overrides;
};

std::ostream& operator<<(std::ostream& out, const ResumeCase& c);
std::string name_of(const ::testing::TestParamInfo<ResumeCase>& instance);

// By every implicit method, with fixed and adaptive steps, with more output, and then `more`.
std::vector<ResumeCase> by_implicit_methods(const std::vector<ResumeCase>& more);

// Runs the mission with and without breaks at random but seeded steps, more or less one in each
// sixth of the run, and compares what both leave. `look` sees the folder of the run without.
void expect_resumes(const std::string& text, const ResumeCase& changed, Outcome outcome,
                    const std::function<void(const std::filesystem::path&)>& look = {});

}  // namespace retiarius::testing
