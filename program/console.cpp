#include "program/console.hpp"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "retiarius/base/error.hpp"

namespace retiarius::program {

namespace {

bool status_shown = false;
bool output_lost = false;
int output_error = 0;

std::size_t terminal_width() {
  winsize size{};
  if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1) return size.ws_col;
  return 80;
}

void clear_status() {
  if (!status_shown) return;
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
  status_shown = false;
}

void tell(const char* kind, const std::string& text) {
  clear_status();
  std::fflush(stdout);  // so that what is printed and what is told come in order
  const std::string line = fmt::format("retiarius: {}: {}\n", kind, text);
  std::fwrite(line.data(), 1, line.size(), stderr);
  std::fflush(stderr);
}

}  // namespace

void print(std::string_view text) {
  clear_status();
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size()) return;
  output_lost = true;
  output_error = errno;
}

void flush_output() {
  errno = 0;
  if (std::fflush(stdout) != 0 && !output_lost) {
    output_lost = true;
    output_error = errno;
  }
  if (output_lost)
    throw RunError(fmt::format("cannot write to standard output: {}", std::strerror(output_error)));
}

void tell_error(const std::string& text) { tell("error", text); }

void tell_warning(const std::string& text) { tell("warning", text); }

bool status_possible() {
  const char* kind = std::getenv("TERM");
  const bool dumb = kind == nullptr || std::strcmp(kind, "dumb") == 0;
  return !dumb && ::isatty(STDERR_FILENO) == 1;
}

void show_status(const std::string& text) {
  if (text.empty()) {
    clear_status();
    return;
  }
  // One column stays free: a full last column would make some terminals wrap.
  const std::string line = "\r\033[K" + text.substr(0, terminal_width() - 1);
  std::fwrite(line.data(), 1, line.size(), stderr);
  std::fflush(stderr);
  status_shown = true;
}

}  // namespace retiarius::program
