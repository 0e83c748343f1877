#include "retiarius/check/check_contact.hpp"

#include "retiarius/base/error.hpp"
#include "retiarius/check/checked_run.hpp"
#include "retiarius/check/threads_on_body.hpp"
#include "retiarius/check/threads_on_threads.hpp"

namespace retiarius {

using namespace check;

const char* to_string(ContactFault fault) {
  switch (fault) {
    case ContactFault::penetration:
      return "penetration";
    case ContactFault::approach:
      return "approach";
    case ContactFault::crossing:
      break;
  }
  return "crossing";
}

namespace {

void check_options(const ContactCheckOptions& options) {
  if (!(options.share > 0.0 && options.share <= 1.0))
    throw InputError("the share of the radii to keep free must lie above 0 and up to 1");
  if (!(options.slack >= 0.0 && options.slack < 1.0))
    throw InputError("the slack must lie from 0 up to, but not at, 1");
}

// Whether thread on thread is checked in a phase.
bool checks_self(const CheckedRun& run, const ContactCheckOptions& options, Index phase) {
  if (options.self) return *options.self;
  const auto k = static_cast<std::size_t>(phase);
  return k < run.self.size() && run.self[k];
}

}  // namespace

ContactCheck check_contact(const std::filesystem::path& folder,
                           const ContactCheckOptions& options) {
  check_options(options);
  const CheckedRun run(folder);
  ThreadsOnThreads threads(run);
  ContactCheck result;
  result.bodies = run.names;
  result.states = run.file.frame_count();
  Tally tally;
  FrameData now;
  if (result.states > 0) now = run.file.frame(0);
  for (std::size_t k = 0; k < result.states; ++k) {
    const bool last = k + 1 == result.states;
    FrameData next;
    if (!last) next = run.file.frame(k + 1);
    for (Index body = 0; body < static_cast<Index>(run.solids.size()); ++body) {
      check_state_on_body(run, now, body, options, tally);
      if (!last) check_motion_on_body(run, now, next, body, options, tally);
    }
    // A motion belongs to the phase at its end.
    if (checks_self(run, options, last ? now.phase : next.phase)) {
      result.self = true;
      threads.check(now, last ? nullptr : &next, options, tally);
    }
    if (!last) ++result.motions;
    now = std::move(next);
  }
  tally.write_to(result);
  return result;
}

}  // namespace retiarius
