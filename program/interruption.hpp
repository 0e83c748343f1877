// Ending a run from outside, with what was computed kept.
#pragma once

#include <atomic>

namespace retiarius::program {

// From now on SIGINT, SIGTERM and SIGUSR1 set the flag that is returned, instead of ending the
// process; a second SIGINT ends it at once. SIGTERM stays blocked in this thread and those that it
// starts: a child process must unblock it.
const std::atomic<bool>& catch_interruptions();

// From now on a pipe that nobody reads any more and a limit on the size of files do not end the
// process: the write fails, and a run comes to its end in good order.
void make_write_failures_errors();

}  // namespace retiarius::program
