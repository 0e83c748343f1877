#include "tests/record/resumed_run.hpp"

#include <algorithm>
#include <atomic>
#include <random>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "retiarius/base/instruction_set.hpp"
#include "retiarius/mission/reader.hpp"
#include "retiarius/mission/run.hpp"
#include "retiarius/mission/writer.hpp"
#include "retiarius/record/file.hpp"
#include "retiarius/record/recorders.hpp"
#include "retiarius/record/resume.hpp"
#include "retiarius/record/run_file.hpp"
#include "tests/record/sample_run.hpp"

namespace retiarius::testing {

namespace {

namespace fs = std::filesystem;

struct Death {};

class Breaker final : public Observer {
 public:
  Breaker(const std::vector<Break>& breaks, std::atomic<bool>& stop)
      : breaks_(breaks), stop_(stop) {}

  void progress(const State&, Index, double) override {
    if (breaks_.empty() || ++steps_ < breaks_.front().steps) return;
    if (breaks_.front().kind == Break::Kind::died) throw Death();
    stop_ = true;
  }

 private:
  std::vector<Break> breaks_;
  std::atomic<bool>& stop_;
  int steps_ = 0;
};

RunReport run_stretch(const fs::path& folder, const Mission& mission,
                      const std::vector<Break>& breaks, bool resume) {
  std::atomic<bool> stop = !breaks.empty() && breaks.front().steps == 0;
  RecordOptions record;
  record.resolved = to_toml(mission);
  record.build = build_info();
  record.build.kernels = kernel_name();
  record.resume = resume;
  RunOptions options;
  options.stop = &stop;
  if (resume) options.resume = resumption(folder, find_resumable(folder));
  const std::unique_ptr<FanOut> observers = make_recorders(folder, record);
  observers->add(std::make_unique<Breaker>(breaks, stop));
  try {
    return run_mission(mission, MissionModel(mission), *observers, options);
  } catch (const Death&) {
    RunReport report;
    report.outcome = Outcome::interrupted;
    return report;
  }
}

std::vector<std::string> files_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) names.push_back(fs::relative(entry.path(), folder).string());
  std::sort(names.begin(), names.end());
  return names;
}

nlohmann::json summary_in(const fs::path& folder) {
  auto summary = nlohmann::json::parse(read_whole_file(folder / "summary.json"));
  summary.erase("timings");
  summary["measures"].erase("wall_time");
  return summary;
}

void expect_same_run_file(const fs::path& one, const fs::path& other) {
  const RunFile a(one), b(other);
  ASSERT_EQ(a.history_names(), b.history_names());
  for (const std::string& name : a.history_names()) {
    const std::vector<double> rows_a = a.history(name), rows_b = b.history(name);
    ASSERT_EQ(rows_a.size(), rows_b.size());
    for (std::size_t k = 0; k < rows_a.size(); ++k)
      EXPECT_TRUE(rows_a[k] == rows_b[k] || (std::isnan(rows_a[k]) && std::isnan(rows_b[k])))
          << name << " " << k;
  }
  ASSERT_EQ(a.frame_times(), b.frame_times());
  EXPECT_EQ(a.frame_phases(), b.frame_phases());
  for (std::size_t k = 0; k < a.frame_count(); ++k) {
    const FrameData fa = a.frame(k), fb = b.frame(k);
    EXPECT_EQ(fa.x, fb.x) << k;
    EXPECT_EQ(fa.v, fb.v) << k;
    EXPECT_EQ(fa.tension, fb.tension) << k;
    EXPECT_EQ(fa.strain, fb.strain) << k;
    EXPECT_EQ(fa.curvature, fb.curvature) << k;
    EXPECT_EQ(fa.contact, fb.contact) << k;
    ASSERT_EQ(fa.bodies.size(), fb.bodies.size());
    for (std::size_t j = 0; j < fa.bodies.size(); ++j) {
      EXPECT_EQ(fa.bodies[j].position, fb.bodies[j].position) << k;
      EXPECT_EQ(fa.bodies[j].attitude.coeffs(), fb.bodies[j].attitude.coeffs()) << k;
      EXPECT_EQ(fa.bodies[j].velocity, fb.bodies[j].velocity) << k;
      EXPECT_EQ(fa.bodies[j].angular_momentum, fb.bodies[j].angular_momentum) << k;
    }
  }
}

}  // namespace

RunReport run_into(const fs::path& folder, const Mission& mission,
                   const std::vector<Break>& breaks) {
  return run_stretch(folder, mission, breaks, false);
}

RunReport resume_in(const fs::path& folder, const Mission& mission,
                    const std::vector<Break>& breaks) {
  return run_stretch(folder, mission, breaks, true);
}

int run_with_breaks(const fs::path& folder, const Mission& mission,
                    const std::vector<Break>& breaks) {
  int count = 0;
  RunReport report = run_into(folder, mission, {breaks.at(0)});
  while (report.outcome == Outcome::interrupted) {
    ++count;
    std::vector<Break> next;
    if (static_cast<std::size_t>(count) < breaks.size()) next = {breaks[count]};
    report = resume_in(folder, mission, next);
  }
  EXPECT_NE(report.outcome, Outcome::failed) << report.reason;
  return count;
}

void expect_same_results(const fs::path& one, const fs::path& other) {
  std::vector<std::string> names = files_in(one);
  EXPECT_EQ(names, files_in(other));
  for (const std::string& name : names) {
    // A durable checkpoint is kept as the one before: which one depends on clocks.
    if (name == "checkpoint.previous" || name == "report.html") continue;
    if (name == "summary.json") {
      EXPECT_EQ(summary_in(one), summary_in(other));
    } else if (name == "run.h5") {
      expect_same_run_file(one / name, other / name);
    } else {
      EXPECT_TRUE(read_whole_file(one / name) == read_whole_file(other / name)) << name;
    }
  }
}

std::ostream& operator<<(std::ostream& out, const ResumeCase& c) { return out << c.name; }

std::string name_of(const ::testing::TestParamInfo<ResumeCase>& instance) {
  return instance.param.name;
}

std::vector<ResumeCase> by_implicit_methods(const std::vector<ResumeCase>& more) {
  const auto method = [](const std::string& name) { return "integrator.method=" + name; };
  const std::string adaptive = "integrator.adaptive=true";
  std::vector<ResumeCase> cases{
      {"implicit_euler", {method("implicit-euler")}},
      {"newmark", {method("newmark"), "integrator.step=0.001"}},
      // Midpoint does not converge on the stiff bent threads of closed nets.
      {"midpoint",
       {method("midpoint"), "integrator.step=0.001", "net.thread.bending=none",
        "net.thread.young_modulus=1.0e6"}},
      {"generalised_alpha", {method("generalised-alpha"), "integrator.rho=0.5"}},
      {"tr_bdf2", {method("tr-bdf2")}},
      {"implicit_euler_adaptive", {method("implicit-euler"), adaptive}},
      {"generalised_alpha_adaptive", {method("generalised-alpha"), adaptive}},
      {"tr_bdf2_adaptive", {method("tr-bdf2"), adaptive}},
      {"fine_output", {"output.interval=0.005", "output.frame_interval=0.005"}},
  };
  cases.insert(cases.end(), more.begin(), more.end());
  return cases;
}

void expect_resumes(const std::string& text, const ResumeCase& changed, Outcome outcome,
                    const std::function<void(const fs::path&)>& look) {
  const Mission mission = parse_mission(text, "mission", RETIARIUS_SOURCE_DIR, changed.overrides);
  const TemporaryFolder folder;
  const RunReport whole = run_into(folder / "whole", mission);
  ASSERT_EQ(whole.outcome, outcome) << whole.reason;
  if (look) look(folder / "whole");
  std::int64_t steps = 0;
  for (const Measure& m : whole.measures)
    if (m.name == "steps") steps = std::get<std::int64_t>(m.value);
  std::minstd_rand random(static_cast<unsigned>(std::string(changed.name).size()));
  std::vector<Break> breaks;
  for (int k = 0; k < 6; ++k)
    breaks.push_back({k % 2 == 0 ? Break::Kind::stopped : Break::Kind::died,
                      1 + static_cast<int>(random() % static_cast<unsigned>(steps / 5))});
  EXPECT_GE(run_with_breaks(folder / "broken", mission, breaks), 3);
  expect_same_results(folder / "whole", folder / "broken");
}

}  // namespace retiarius::testing
