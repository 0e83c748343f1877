// From the arguments to a command and to the program's exit code.
#pragma once

namespace retiarius::program {

// Runs the command that the arguments name and returns the exit code (exit_code.hpp). Errors are
// told on stderr; never throws.
int run_command_line(int argc, char** argv) noexcept;

}  // namespace retiarius::program
