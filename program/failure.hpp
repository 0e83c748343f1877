// What an exception means to the user of the program.
#pragma once

#include <exception>

#include "program/exit_code.hpp"

namespace retiarius::program {

// Tells the error on stderr and returns the exit code for it.
ExitCode tell_failure(std::exception_ptr failure) noexcept;

}  // namespace retiarius::program
