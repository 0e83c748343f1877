// What a person at a terminal sees: one line that changes, and is gone at the end.
#include <csignal>
#include <cstdlib>

#include <gmock/gmock.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/program/subprocess.hpp"

namespace retiarius {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::WorkFolder;

struct Seen {
  std::string text;
  int exit_code = -1;
};

// Runs the endless mission on a terminal of so many columns, presses Ctrl-C once `until` is seen
// and returns all that came.
Seen on_terminal(const WorkFolder& folder, unsigned short columns, const char* kind,
                 const std::string& until, const std::vector<std::string>& more = {}) {
  folder.write("m.toml", testing::endless_mission());
  std::vector<std::string> all{RETIARIUS_PROGRAM, "run", "m.toml"};
  all.insert(all.end(), more.begin(), more.end());
  std::vector<char*> argv;
  for (std::string& argument : all) argv.push_back(argument.data());
  argv.push_back(nullptr);
  winsize size{};
  size.ws_row = 24;
  size.ws_col = columns;
  int terminal = -1;
  const pid_t id = ::forkpty(&terminal, nullptr, nullptr, &size);
  if (id == 0) {
    ::setenv("TERM", kind, 1);
    if (::chdir(folder.path().c_str()) == 0) ::execv(RETIARIUS_PROGRAM, argv.data());
    ::_exit(127);
  }
  ::alarm(60);  // ends the test where the text never comes
  Seen seen;
  char buffer[4096];
  bool pressed = false;
  for (ssize_t n; (n = ::read(terminal, buffer, sizeof buffer)) > 0;) {
    seen.text.append(buffer, static_cast<std::size_t>(n));
    if (pressed || seen.text.find(until) == std::string::npos) continue;
    pressed = ::write(terminal, "\x03", 1) == 1;
  }
  ::alarm(0);
  int status = 0;
  ::waitpid(id, &status, 0);
  if (WIFEXITED(status)) seen.exit_code = WEXITSTATUS(status);
  ::close(terminal);
  return seen;
}

TEST(Terminal, ShowsProgressAndSpeedAndTakesCtrlC) {
  const WorkFolder folder;
  const Seen seen = on_terminal(folder, 120, "xterm", "left");
  EXPECT_EQ(seen.exit_code, 4);
  EXPECT_THAT(seen.text, ContainsRegex("\r\033\\[K\\[>? +\\] +0 %  free 1/1  t = [0-9.]+ s  "
                                       "[0-9.e+]+ x real time  .* left"));
  EXPECT_THAT(seen.text, HasSubstr("stopping after this step; Ctrl-C again ends at once"));
  EXPECT_THAT(seen.text, HasSubstr("\r\033[Kinterrupted: A small net\r\n"));
}

TEST(Terminal, LineIsCutToItsWidth) {
  const WorkFolder folder;
  const Seen seen = on_terminal(folder, 30, "xterm", "%");
  EXPECT_THAT(seen.text, Not(HasSubstr("free 1/1  t")));
  EXPECT_THAT(seen.text, HasSubstr("\r\033[K[>         ]   0 %  free 1/1 "));
}

TEST(Terminal, QuietAndDumbTerminalsShowNoProgress) {
  // Nothing will come to wait for: the run ends by itself.
  const std::vector<std::string> short_run{"--set", "phase[0].until=time >= 20"};
  const WorkFolder first, second;
  const Seen dumb = on_terminal(first, 80, "dumb", "\x01", short_run);
  EXPECT_EQ(dumb.exit_code, 0);
  EXPECT_THAT(dumb.text, Not(HasSubstr("\033[K")));
  std::vector<std::string> quiet_run = short_run;
  quiet_run.push_back("--quiet");
  const Seen quiet = on_terminal(second, 80, "xterm", "\x01", quiet_run);
  EXPECT_EQ(quiet.exit_code, 0);
  EXPECT_EQ(quiet.text, "");
}

}  // namespace
}  // namespace retiarius
