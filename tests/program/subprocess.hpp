// Runs the real program as a user would, with its output and exit code captured.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <sys/resource.h>
#include <sys/types.h>

namespace retiarius::testing {

struct ProcessResult {
  int exit_code = -1;  // -1 where a signal ended it
  int signal = 0;      // that ended it; 0 where none did
  std::string out, err;
};

struct ProcessOptions {
  std::optional<rlim_t> address_space;  // bytes, RLIMIT_AS
  std::optional<rlim_t> file_size;      // bytes, RLIMIT_FSIZE
  std::filesystem::path out;            // takes stdout in place of the capture
};

// The program at work in `folder`. Whoever makes one waits for it.
class Process {
 public:
  Process(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
          const ProcessOptions& options = {});
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  void send(int signal) const;
  pid_t id() const { return id_; }
  bool running();
  ProcessResult wait();

 private:
  pid_t id_ = -1;
  std::optional<int> status_;
  std::filesystem::path out_, err_;
};

// An empty folder to work in, removed at the end of the test.
class WorkFolder {
 public:
  WorkFolder();
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

  // Writes a file and returns its name.
  std::string write(const std::string& name, const std::string& text) const;
  std::string read(const std::string& name) const;
  bool has(const std::string& name) const { return std::filesystem::exists(path_ / name); }
  // Names of everything in it, in order, separated by blanks.
  std::string listing() const;

  // Runs the program here.
  ProcessResult run(const std::vector<std::string>& arguments,
                    const ProcessOptions& options = {}) const;

 private:
  std::filesystem::path path_;
};

// A small net under gravity, held at its corners: 31 nodes, 0.2 s, twenty steps.
std::string small_mission();

// The same with as many steps as it takes to be interrupted.
std::string endless_mission();

// A text with one piece of it replaced.
std::string replaced(std::string text, const std::string& from, const std::string& to);

// Rows of a CSV file's text, the header included.
std::size_t line_count(const std::string& text);

}  // namespace retiarius::testing
