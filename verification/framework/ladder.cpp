#include "verification/framework/ladder.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/mission/nearest.hpp"

namespace retiarius::verification {

const char* title(Group group) {
  switch (group) {
    case Group::paper:
      return "The figures of Huang et al. (2022)";
    case Group::rods:
      return "Rods";
    case Group::cables:
      return "Cables and pretensioned nets";
    case Group::dynamics:
      return "Dynamics";
    case Group::contact:
      return "Contact and bodies";
    case Group::deployment:
      return "Deployment";
    case Group::convergence:
      return "Convergence";
  }
  return "";
}

CaseResult run_case(const Case& of, bool quick, const Fault& fault) {
  const auto start = std::chrono::steady_clock::now();
  Context context(of, quick, fault);
  try {
    of.run(context);
  } catch (const std::exception& e) {
    context.result().failure = e.what();
  }
  CaseResult result = std::move(context.result());
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  result.wall_time = wall.count();
  return result;
}

std::vector<Rung> climb(const std::vector<const Case*>& cases, bool quick, int workers,
                        const std::function<void(const Rung&)>& finished) {
  std::vector<Rung> rungs(cases.size());
  std::atomic<std::size_t> next{0};
  std::mutex telling;
  const auto work = [&] {
    for (std::size_t k = next++; k < cases.size(); k = next++) {
      rungs[k] = {cases[k], run_case(*cases[k], quick)};
      const std::lock_guard lock(telling);
      if (finished) finished(rungs[k]);
    }
  };
  std::vector<std::thread> others;
  for (int i = 1; i < workers; ++i) others.emplace_back(work);
  work();
  for (std::thread& t : others) t.join();
  return rungs;
}

std::vector<const Case*> chosen_cases(const std::vector<std::string>& names) {
  std::vector<std::string> known;
  std::vector<const Case*> chosen;
  for (const Case& c : all_cases()) known.push_back(c.name);
  if (names.empty())
    for (const Case& c : all_cases()) chosen.push_back(&c);
  for (const std::string& name : names) {
    const auto at = std::find(known.begin(), known.end(), name);
    if (at == known.end())
      throw InputError(
          fmt::format("there is no verification case {}{}; `retiarius verify --list` "
                      "lists them",
                      name, suggestion(name, known)));
    chosen.push_back(&all_cases()[static_cast<std::size_t>(at - known.begin())]);
  }
  return chosen;
}

bool passes(const std::vector<Rung>& rungs) {
  return std::all_of(rungs.begin(), rungs.end(), [](const Rung& r) { return r.result.passes(); });
}

}  // namespace retiarius::verification
