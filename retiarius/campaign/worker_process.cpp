#include "retiarius/campaign/worker_process.hpp"

#include <cerrno>
#include <csignal>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "retiarius/campaign/execute.hpp"

namespace retiarius {

namespace {

constexpr int kEarlyDeaths = 50;  // of workers in a row, before any run

// In the child, between fork and exec: only calls that are safe there.
[[noreturn]] void become_worker(int orders, int answers, pid_t parent, char* const* arguments) {
  // The child ends with its coordinator, however that ends.
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(127);
  // Ctrl-C reaches the whole group; the coordinator decides.
  std::signal(SIGINT, SIG_IGN);
  // What the coordinator blocks, its workers do not.
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  if (::dup2(orders, STDIN_FILENO) < 0 || ::dup2(answers, STDOUT_FILENO) < 0) ::_exit(127);
  ::close_range(3, ~0u, 0);
  ::execv(arguments[0], arguments);
  ::_exit(127);
}

std::string ending_of(int status) {
  if (WIFSIGNALED(status))
    return fmt::format("signal {} ({})", WTERMSIG(status), ::strsignal(WTERMSIG(status)));
  return fmt::format("exit code {}", WEXITSTATUS(status));
}

}  // namespace

WorkerProcess::WorkerProcess(const Campaign& campaign, WorkerSettings settings)
    : campaign_(&campaign), settings_(std::move(settings)) {}

WorkerProcess::~WorkerProcess() { stop(); }

std::filesystem::path WorkerProcess::shard_path() const {
  return settings_.folder / "shards" / (settings_.shard + ".sqlite");
}

void WorkerProcess::start() {
  std::vector<std::string> words = {
      settings_.program,         "campaign", "worker",        settings_.campaign, "--out",
      settings_.folder.string(), "--shard",  settings_.shard, "--engine",         settings_.engine};
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  int down[2], up[2];
  if (::pipe2(down, O_CLOEXEC) != 0)
    throw RunError(fmt::format("cannot start a worker: {}", std::strerror(errno)));
  if (::pipe2(up, O_CLOEXEC) != 0) {
    ::close(down[0]);
    ::close(down[1]);
    throw RunError(fmt::format("cannot start a worker: {}", std::strerror(errno)));
  }
  const pid_t parent = ::getpid();
  process_ = ::fork();
  if (process_ == 0) become_worker(down[0], up[1], parent, arguments.data());
  ::close(down[0]);
  ::close(up[1]);
  orders_ = down[1];
  answers_ = up[0];
  ready_ = false;
  text_.clear();
  failure_.clear();
  if (process_ < 0) {
    stop();
    throw RunError(fmt::format("cannot start a worker: {}", std::strerror(errno)));
  }
  ::fcntl(answers_, F_SETFL, O_NONBLOCK);
}

void WorkerProcess::stop() {
  if (orders_ >= 0) ::close(orders_);
  if (answers_ >= 0) ::close(answers_);
  orders_ = answers_ = -1;
  if (process_ > 0) {
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }
  process_ = -1;
}

void WorkerProcess::begin(std::int64_t id) {
  id_ = id;
  attempt_ = 1;
  if (process_ < 0) start();
  send();
}

void WorkerProcess::send() {
  const std::string order = fmt::format("{} {}\n", *id_, attempt_);
  // A child that is dead by now is found so by advance().
  [[maybe_unused]] const auto written = ::write(orders_, order.data(), order.size());
  begun_ = Clock::now();
}

// False once the child has closed its end.
bool WorkerProcess::read_answers() {
  char bytes[512];
  for (;;) {
    const ssize_t count = ::read(answers_, bytes, sizeof bytes);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno == EAGAIN || errno == EWOULDBLOCK;
    if (count == 0) return false;
    text_.append(bytes, static_cast<std::size_t>(count));
  }
}

std::optional<WorkerProcess::Finished> WorkerProcess::take(const std::string& line) {
  if (line.rfind("ready ", 0) == 0) {
    if (line.substr(6) != campaign_->identity().text())
      throw RunError(
          fmt::format("{}: the campaign, its mission or the program has changed while "
                      "it runs",
                      settings_.campaign));
    ready_ = true;
  } else if (line.rfind("failed ", 0) == 0) {
    failure_ = line.substr(7);
  } else if (line.rfind("done ", 0) == 0) {
    std::size_t used = 0;
    const std::string rest = line.substr(5);
    const std::int64_t id = std::stoll(rest, &used);
    const auto state = static_cast<RunState>(std::stoi(rest.substr(used)));
    id_.reset();
    return Finished{id, state};
  }
  return std::nullopt;
}

// Runs check their clock after every step; one step that takes for ever is ended from here.
bool WorkerProcess::overdue() const {
  const double limit = campaign_->spec().limits.wall_clock;
  return id_ && std::chrono::duration<double>(Clock::now() - begun_).count() > 1.5 * limit + 10.0;
}

std::optional<WorkerProcess::Finished> WorkerProcess::advance() {
  if (process_ < 0) return std::nullopt;
  const bool open = read_answers();
  std::optional<Finished> finished;
  for (auto end = text_.find('\n'); end != std::string::npos && !finished; end = text_.find('\n')) {
    const std::string line = text_.substr(0, end);
    text_.erase(0, end + 1);
    finished = take(line);
  }
  if (finished) return finished;
  if (!open) return take_death();
  if (!overdue()) return std::nullopt;
  stop();
  RunRecord words;
  set_timeout(words, campaign_->spec().limits);
  return record_end(words.outcome, words.reason);
}

std::optional<WorkerProcess::Finished> WorkerProcess::take_death() {
  int status = 0;
  ::waitpid(process_, &status, 0);
  process_ = -1;
  const bool was_ready = ready_;
  stop();
  if (!failure_.empty()) throw RunError(failure_);
  const std::string ending = ending_of(status);
  // Before it was ready no run can be to blame, but whoever kills processes may have been quick.
  if (!was_ready && !WIFSIGNALED(status))
    throw RunError(fmt::format("a worker ended before it began, with {}", ending));
  if (!id_) return std::nullopt;
  Shard shard(shard_path(), campaign_->identity());
  if (shard.has(*id_)) {
    // Its row was written, but the answer did not come through.
    const Finished finished{*id_, shard.state(*id_)};
    id_.reset();
    return finished;
  }
  const std::int64_t attempts = campaign_->spec().limits.attempts;
  if (attempt_ >= attempts)
    return record_end("killed", fmt::format("its process died in each of {} attempts, the last "
                                            "time by {}",
                                            attempts, ending));
  if (was_ready) {
    ++attempt_;
    died_early_ = 0;
  } else if (++died_early_ > kEarlyDeaths) {
    throw RunError(
        fmt::format("workers end before they begin, {} in a row, the last with {}; is "
                    "there enough memory?",
                    died_early_, ending));
  }
  start();
  send();
  return std::nullopt;
}

WorkerProcess::Finished WorkerProcess::record_end(const std::string& outcome,
                                                  const std::string& reason) {
  Shard shard(shard_path(), campaign_->identity());
  const std::int64_t id = *id_;
  id_.reset();
  if (shard.has(id)) return {id, shard.state(id)};
  RunRecord record = planned_record(*campaign_, id);
  record.outcome = outcome;
  record.reason = reason;
  record.engine = settings_.engine;
  record.attempts = attempt_;
  record.wall_time = std::chrono::duration<double>(Clock::now() - begun_).count();
  shard.write(record);
  return {id, kNoAnswer};
}

}  // namespace retiarius
