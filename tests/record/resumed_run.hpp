// Runs missions into folders, interrupted and resumed at will, and compares what they leave.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

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

}  // namespace retiarius::testing
