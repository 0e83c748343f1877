// Ending a run from outside, with what was computed kept.
#pragma once

#include <atomic>

namespace retiarius::program {

// From now on SIGINT, SIGTERM and SIGUSR1 set the flag that is returned, instead of ending the
// process; a second SIGINT ends it at once. A pipe that nobody reads any more and a limit on the
// size of files do not end it: the write fails, and the run ends in good order.
const std::atomic<bool>& catch_interruptions();

}  // namespace retiarius::program
