#include "benchmarks/missions.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <variant>

#include "retiarius/base/parallel.hpp"
#include "retiarius/mission/reader.hpp"
#include "retiarius/mission/run.hpp"

namespace retiarius::benchmarks {

namespace {

std::int64_t count(const Measures& measures, const std::string& name) {
  const auto found = std::find_if(measures.begin(), measures.end(),
                                  [&](const Measure& m) { return m.name == name; });
  if (found == measures.end()) return 0;
  const std::int64_t* number = std::get_if<std::int64_t>(&found->value);
  return number ? *number : 0;
}

}  // namespace

MissionTime time_mission(const std::string& file, const std::vector<std::string>& overrides) {
  const Mission mission = read_mission(file, overrides);
  MissionTime time;
  time.name = std::filesystem::path(file).stem().string();
  for (const std::string& text : overrides)
    time.overrides += (time.overrides.empty() ? "" : " ") + text;
  time.threads = threads();
  Observer nobody;
  const auto start = std::chrono::steady_clock::now();
  const MissionModel model(mission);
  const RunReport report = run_mission(mission, model, nobody);
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  time.seconds = wall.count();
  time.outcome = to_string(report.outcome);
  time.simulated = report.phases.empty() ? 0.0 : report.phases.back().end;
  time.steps = count(report.measures, "steps");
  time.iterations = count(report.measures, "newton_iterations");
  time.unconverged = count(report.measures, "unconverged_steps");
  return time;
}

}  // namespace retiarius::benchmarks
