#include "retiarius/campaign/worker.hpp"

#include <algorithm>
#include <cerrno>
#include <optional>

#include <fmt/format.h>
#include <unistd.h>

#include "retiarius/base/parallel.hpp"
#include "retiarius/campaign/execute.hpp"
#include "retiarius/campaign/shard.hpp"

namespace retiarius {

namespace {

// Lines from a descriptor.
class Orders {
 public:
  explicit Orders(int descriptor) : descriptor_(descriptor) {}

  std::optional<std::string> line() {
    for (;;) {
      const auto end = text_.find('\n');
      if (end != std::string::npos) {
        std::string first = text_.substr(0, end);
        text_.erase(0, end + 1);
        return first;
      }
      char bytes[256];
      const ssize_t count = ::read(descriptor_, bytes, sizeof bytes);
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return std::nullopt;
      text_.append(bytes, static_cast<std::size_t>(count));
    }
  }

 private:
  int descriptor_;
  std::string text_;
};

// A coordinator that is gone takes no answers; then there are no more orders either.
void say(int descriptor, const std::string& text) {
  const std::string line = text + "\n";
  [[maybe_unused]] const auto written = ::write(descriptor, line.data(), line.size());
}

void serve(const Campaign& campaign, const WorkerTask& task) {
  Shard shard(task.folder / "shards" / (task.shard + ".sqlite"), campaign.identity());
  say(task.answers, "ready " + campaign.identity().text());
  Orders orders(task.orders);
  while (const auto order = orders.line()) {
    // "ID ATTEMPT"
    std::size_t used = 0;
    const std::int64_t id = std::stoll(*order, &used);
    std::optional<RunRecord> record = execute_and_keep(campaign, id, task.folder);
    if (!record) return;
    record->engine = task.engine;
    record->attempts = std::stoll(order->substr(used));
    shard.write(*record);
    say(task.answers, fmt::format("done {} {}", id, static_cast<int>(run_state(record->success))));
  }
}

}  // namespace

void work(const Campaign& campaign, const WorkerTask& task) {
  set_threads(1);
  try {
    serve(campaign, task);
  } catch (const Error& error) {
    std::string text = error.what();
    std::replace(text.begin(), text.end(), '\n', ' ');
    say(task.answers, "failed " + text);
  }
}

}  // namespace retiarius
