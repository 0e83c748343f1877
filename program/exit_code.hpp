// The exit codes of the program, as scripts rely on them.
#pragma once

namespace retiarius::program {

enum ExitCode : int {
  kOk = 0,
  kFailed = 1,       // the run failed, or its outcome is `broke`
  kBadInput = 2,     // wrong usage or input; nothing was written
  kInterrupted = 4,  // by SIGINT, SIGTERM or SIGUSR1
};

}  // namespace retiarius::program
