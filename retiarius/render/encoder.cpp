#include "retiarius/render/encoder.hpp"

#include <csignal>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "retiarius/base/error.hpp"

namespace retiarius::render {

void require_ffmpeg() {
  const char* path = std::getenv("PATH");
  std::string_view rest = path ? path : "/usr/bin:/bin";
  for (;;) {
    const std::size_t end = std::min(rest.find(':'), rest.size());
    const std::filesystem::path file = std::filesystem::path(rest.substr(0, end)) / "ffmpeg";
    if (end > 0 && ::access(file.c_str(), X_OK) == 0) return;
    if (end == rest.size()) break;
    rest.remove_prefix(end + 1);
  }
  throw InputError(
      "films need the program ffmpeg, which is not found; on Debian: apt-get install ffmpeg");
}

Encoder::Encoder(const std::vector<std::string>& command) : name_(command.at(0)) {
  // A socket pair and not a pipe, because writing to one can be told to raise no SIGPIPE.
  int pair[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pair) != 0)
    throw RunError(fmt::format("cannot start {}: {}", name_, std::strerror(errno)));
  std::FILE* messages = std::tmpfile();
  if (messages == nullptr) {
    ::close(pair[0]), ::close(pair[1]);
    throw RunError(fmt::format("cannot start {}: {}", name_, std::strerror(errno)));
  }
  messages_ = ::fcntl(::fileno(messages), F_DUPFD_CLOEXEC, 3);
  std::fclose(messages);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, pair[1], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, messages_, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, messages_, STDERR_FILENO);
  std::vector<std::string> words = command;
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const int error = ::posix_spawnp(&id_, argv[0], &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(pair[1]);
  input_ = pair[0];
  if (error != 0) {
    id_ = -1;
    ::close(input_), ::close(messages_);
    throw RunError(fmt::format("cannot start {}: {}", name_, std::strerror(error)));
  }
}

Encoder::~Encoder() {
  if (input_ >= 0) ::close(input_);
  if (id_ > 0) {
    ::kill(id_, SIGTERM);
    wait();
  }
  if (messages_ >= 0) ::close(messages_);
}

void Encoder::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(input_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) fail();
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
}

void Encoder::finish() {
  ::close(input_);
  input_ = -1;
  if (wait() != 0) fail();
}

int Encoder::wait() {
  int status = -1;
  while (::waitpid(id_, &status, 0) < 0 && errno == EINTR) {
  }
  id_ = -1;
  return status;
}

void Encoder::fail() {
  if (input_ >= 0) ::close(input_);
  input_ = -1;
  if (id_ > 0) wait();
  std::string text(2000, '\0');
  const off_t size = ::lseek(messages_, 0, SEEK_END);
  const off_t from = std::max<off_t>(0, size - static_cast<off_t>(text.size()));
  const ssize_t count = ::pread(messages_, text.data(), text.size(), from);
  text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  throw RunError(fmt::format("{} failed: {}", name_, text.empty() ? "it gave no reason" : text));
}

}  // namespace retiarius::render
