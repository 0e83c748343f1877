#include "tests/program/subprocess.hpp"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace retiarius::testing {

namespace fs = std::filesystem;

namespace {

std::string content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

fs::path temporary_name(const char* kind) {
  std::string name = (fs::temp_directory_path() / (std::string("retiarius-") + kind)).string();
  name += "-XXXXXX";
  const int file = ::mkstemp(name.data());
  if (file < 0) throw std::runtime_error("cannot make a temporary file");
  ::close(file);
  return name;
}

void limit(int resource, const std::optional<rlim_t>& bytes) {
  if (!bytes) return;
  const rlimit value{*bytes, *bytes};
  if (::setrlimit(resource, &value) != 0) ::_exit(126);
}

void redirect(int descriptor, const fs::path& path) {
  const int file = ::open(path.c_str(), O_WRONLY);
  if (file < 0 || ::dup2(file, descriptor) < 0) ::_exit(126);
}

}  // namespace

Process::Process(const std::vector<std::string>& arguments, const fs::path& folder,
                 const ProcessOptions& options)
    : out_(temporary_name("out")), err_(temporary_name("err")) {
  std::vector<std::string> all{RETIARIUS_PROGRAM};
  all.insert(all.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& argument : all) argv.push_back(argument.data());
  argv.push_back(nullptr);
  id_ = ::fork();
  if (id_ < 0) throw std::runtime_error("cannot fork");
  if (id_ > 0) return;
  redirect(STDOUT_FILENO, options.out.empty() ? out_ : options.out);
  redirect(STDERR_FILENO, err_);
  if (::chdir(folder.c_str()) != 0) ::_exit(126);
  limit(RLIMIT_AS, options.address_space);
  limit(RLIMIT_FSIZE, options.file_size);
  ::execv(RETIARIUS_PROGRAM, argv.data());
  ::_exit(127);
}

Process::~Process() {
  if (!status_) {
    ::kill(id_, SIGKILL);
    ::waitpid(id_, nullptr, 0);
  }
  std::error_code ignored;
  fs::remove(out_, ignored);
  fs::remove(err_, ignored);
}

void Process::send(int signal) const { ::kill(id_, signal); }

bool Process::running() {
  int status = 0;
  if (!status_ && ::waitpid(id_, &status, WNOHANG) == id_) status_ = status;
  return !status_;
}

ProcessResult Process::wait() {
  int status = 0;
  if (!status_ && ::waitpid(id_, &status, 0) == id_) status_ = status;
  ProcessResult result;
  if (WIFEXITED(*status_)) result.exit_code = WEXITSTATUS(*status_);
  if (WIFSIGNALED(*status_)) result.signal = WTERMSIG(*status_);
  result.out = content(out_);
  result.err = content(err_);
  return result;
}

WorkFolder::WorkFolder() {
  std::string name = (fs::temp_directory_path() / "retiarius-program-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder");
  path_ = name;
}

WorkFolder::~WorkFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string WorkFolder::write(const std::string& name, const std::string& text) const {
  std::ofstream file(path_ / name, std::ios::binary);
  file << text;
  if (!file.flush()) throw std::runtime_error("cannot write " + name);
  return name;
}

std::string WorkFolder::read(const std::string& name) const { return content(path_ / name); }

std::string WorkFolder::listing() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(path_))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : " ") + name;
  return text;
}

ProcessResult WorkFolder::run(const std::vector<std::string>& arguments,
                              const ProcessOptions& options) const {
  return Process(arguments, path_, options).wait();
}

std::string small_mission() {
  return R"(title = "A small net"

[net]
pattern = "hexagon"
side = 1.0
mesh = 0.5
segments = 2

[net.thread]
young_modulus = 1.0e6
density = 1000.0
radius = 0.01

[environment]
gravity = [0.0, 0.0, -50.0]

[integrator]
step = 0.01

[[phase]]
kind = "free"
fix = "corners"
until = "time >= 0.2"

[[probe]]
name = "center"
node = "center"

[output]
interval = 0.02
frame_interval = 0.1
)";
}

std::string endless_mission() { return replaced(small_mission(), "time >= 0.2", "time >= 1.0e5"); }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("no such text: " + from);
  return text.replace(at, from.size(), to);
}

std::size_t line_count(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace retiarius::testing
