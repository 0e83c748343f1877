#include "retiarius/solve/front_memory.hpp"

#include <algorithm>
#include <map>

namespace retiarius {

namespace {

constexpr double kTaskShare = 1.0 / 24.0;  // of the whole estimated time
constexpr double kSmallestTask = 20000.0;  // ns, below which a thread is not worth waking

// First-fit allocation of ranges, simulated.
class RangeStore {
 public:
  std::size_t take(std::size_t size) {
    for (auto it = free_.begin(); it != free_.end(); ++it) {
      if (it->second < size) continue;
      const std::size_t start = it->first;
      const std::size_t rest = it->second - size;
      free_.erase(it);
      if (rest > 0) free_.emplace(start + size, rest);
      return start;
    }
    // Grow, using a free range that ends where the memory ends.
    std::size_t start = end_;
    if (!free_.empty()) {
      const auto last = std::prev(free_.end());
      if (last->first + last->second == end_) {
        start = last->first;
        free_.erase(last);
      }
    }
    end_ = start + size;
    return start;
  }

  void give(std::size_t start, std::size_t size) {
    if (size == 0) return;
    auto it = free_.emplace(start, size).first;
    const auto next = std::next(it);
    if (next != free_.end() && it->first + it->second == next->first) {
      it->second += next->second;
      free_.erase(next);
    }
    if (it == free_.begin()) return;
    const auto before = std::prev(it);
    if (before->first + before->second == it->first) {
      before->second += it->second;
      free_.erase(it);
    }
  }

  std::size_t end() const { return end_; }

 private:
  std::map<std::size_t, std::size_t> free_;  // start, size; never adjacent
  std::size_t end_ = 0;
};

std::size_t update_size(const Front& front) {
  return static_cast<std::size_t>(front.update_ld) * static_cast<std::size_t>(front.rows_below());
}

void take_shared(Symbolic& symbolic, Front& front) {
  front.update_shared = true;
  front.task_update = symbolic.shared_size;
  symbolic.shared_size += update_size(front);
}

void place_task_updates(Symbolic& symbolic, FrontTask& task) {
  RangeStore store;
  for (Index f = task.begin; f < task.end; ++f) {
    Front& front = symbolic.fronts[f];
    if (f + 1 == task.end) {
      take_shared(symbolic, front);
    } else {
      front.task_update = store.take(update_size(front));
    }
    for (std::size_t c = front.child_begin; c < front.child_end; ++c) {
      const Front& child = symbolic.fronts[symbolic.children[c]];
      store.give(child.task_update, update_size(child));
    }
  }
  task.memory = store.end();
  task.offset = symbolic.tasks_size;
  symbolic.tasks_size += task.memory;
}

}  // namespace

void assign_tasks(Symbolic& symbolic) {
  std::vector<Front>& fronts = symbolic.fronts;
  const auto count = static_cast<Index>(fronts.size());
  std::vector<double> cost(fronts.size(), 0.0);
  std::vector<Index> first(fronts.size());  // of the subtree, which is contiguous
  double total = 0.0;
  for (Index f = 0; f < count; ++f) first[f] = f;
  for (Index f = 0; f < count; ++f) {
    const double own = front_cost(fronts[f].columns, fronts[f].below);
    cost[f] += own;
    total += own;
    if (fronts[f].parent == kNone) continue;
    cost[fronts[f].parent] += cost[f];
    first[fronts[f].parent] = std::min(first[fronts[f].parent], first[f]);
  }
  const double limit = std::max(kSmallestTask, kTaskShare * total);
  for (Index f = 0; f < count; ++f) {
    const Index parent = fronts[f].parent;
    if (cost[f] > limit) {
      symbolic.top.push_back(f);
    } else if (parent == kNone || cost[parent] > limit) {
      for (Index g = first[f]; g <= f; ++g)
        fronts[g].task = static_cast<Index>(symbolic.tasks.size());
      symbolic.tasks.push_back({first[f], f + 1, 0, 0});
    }
  }
}

void place_updates(Symbolic& symbolic) {
  std::vector<Front>& fronts = symbolic.fronts;
  RangeStore all;
  for (Front& front : fronts) {
    front.update = all.take(update_size(front));
    for (std::size_t c = front.child_begin; c < front.child_end; ++c) {
      const Front& child = fronts[symbolic.children[c]];
      all.give(child.update, update_size(child));
    }
  }
  symbolic.update_size = all.end();
  for (FrontTask& task : symbolic.tasks) place_task_updates(symbolic, task);
  for (const Index f : symbolic.top) take_shared(symbolic, fronts[f]);
}

}  // namespace retiarius
