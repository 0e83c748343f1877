// Threads against one body, at a state and from it to the next.
#pragma once

#include <functional>

#include "retiarius/check/checked_run.hpp"
#include "retiarius/check/tally.hpp"

namespace retiarius::check {

// Adds what is wrong at state `now`.
void check_state_on_body(const CheckedRun& run, const FrameData& now, Index body,
                         const ContactCheckOptions& options, Tally& tally);

// Adds what is wrong on the way from `now` to `next`.
void check_motion_on_body(const CheckedRun& run, const FrameData& now, const FrameData& next,
                          Index body, const ContactCheckOptions& options, Tally& tally);

// Calls part(k, tally) for all k below count, in parallel; the sum does not depend on the number of
// threads.
void add_in_parts(std::size_t count, Tally& sum,
                  const std::function<void(std::size_t, Tally&)>& part);

// The fault of a motion whose least distance this is.
ContactFault fault_of_motion(double least, double resolution);

// The share of the radii to which motions are resolved.
inline constexpr double kResolution = 0.02;

}  // namespace retiarius::check
