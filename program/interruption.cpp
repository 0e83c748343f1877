#include "program/interruption.hpp"

#include <csignal>
#include <mutex>
#include <string_view>
#include <thread>

#include <unistd.h>

#include "program/console.hpp"

namespace retiarius::program {

namespace {

std::atomic<bool> stop_requested{false};
static_assert(std::atomic<bool>::is_always_lock_free);  // a signal handler may set it

volatile std::sig_atomic_t announce = 0;

extern "C" void request_stop(int) {
  stop_requested = true;
  if (announce == 0) return;
  constexpr std::string_view kText =
      "\r\033[Kstopping after this step; Ctrl-C again ends at once, without saving\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, kText.data(), kText.size());
}

void handle(int signal, int flags) {
  struct sigaction action {};
  action.sa_handler = request_stop;
  action.sa_flags = flags;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

// SIGTERM is blocked in this thread and all that it starts from now on, and taken by a thread that
// waits for it: whoever replaces its handler for a while, as METIS does, never sees it. A thread
// from before runs the handler.
void await_termination() {
  sigset_t termination;
  sigemptyset(&termination);
  sigaddset(&termination, SIGTERM);
  ::pthread_sigmask(SIG_BLOCK, &termination, nullptr);
  static std::once_flag once;
  std::call_once(once, [termination] {
    std::thread([termination] {
      for (int signal = 0;;)
        if (::sigwait(&termination, &signal) == 0) request_stop(signal);
    }).detach();
  });
}

}  // namespace

const std::atomic<bool>& catch_interruptions() {
  announce = status_possible() ? 1 : 0;
  handle(SIGINT, SA_RESTART | static_cast<int>(SA_RESETHAND));
  handle(SIGTERM, SA_RESTART);
  handle(SIGUSR1, SA_RESTART);
  await_termination();
  return stop_requested;
}

void make_write_failures_errors() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace retiarius::program
