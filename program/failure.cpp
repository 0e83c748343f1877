#include "program/failure.hpp"

#include <cstdio>
#include <filesystem>
#include <new>

#include <fmt/format.h>

#include "program/console.hpp"
#include "retiarius/base/error.hpp"

namespace retiarius::program {

namespace {

ExitCode told(std::exception_ptr failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const InputError& error) {
    tell_error(error.what());
    return kBadInput;
  } catch (const Error& error) {
    tell_error(error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    tell_error(fmt::format("{}: {}", error.path1().string(), error.code().message()));
  } catch (const std::exception& error) {
    tell_error(fmt::format("unexpected: {}", error.what()));
  }
  return kFailed;
}

}  // namespace

ExitCode tell_failure(std::exception_ptr failure) noexcept {
  try {
    std::rethrow_exception(failure);
  } catch (const std::bad_alloc&) {
    // Nothing is composed here: there may be no memory left for it.
    std::fputs(
        "retiarius: error: not enough memory; use a coarser net (net.mesh, net.segments), or see "
        "what it needs with `retiarius info`\n",
        stderr);
    return kFailed;
  } catch (...) {
  }
  try {
    return told(failure);
  } catch (...) {
    std::fputs("retiarius: error: failed, and cannot say why\n", stderr);
    return kFailed;
  }
}

}  // namespace retiarius::program
