#include "retiarius/campaign/execute.hpp"

#include <array>
#include <chrono>
#include <cmath>
#include <new>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include "retiarius/base/build_info.hpp"
#include "retiarius/base/instruction_set.hpp"
#include "retiarius/campaign/kept_results.hpp"
#include "retiarius/campaign/run_limits.hpp"
#include "retiarius/mission/run.hpp"
#include "retiarius/record/checkpoint.hpp"

namespace retiarius {

namespace {

// Passes calls to the limits and to the recorder; what the recorder throws ends the run and is
// kept, because a full disk is no property of the run.
class Watched : public Observer {
 public:
  Watched(RunLimits& limits, Observer* recorder) : limits_(limits), recorder_(recorder) {}

  void begin(const RunModel& model) override {
    told([&] { recorder_->begin(model); });
  }
  void history(const HistoryRow& row) override {
    told([&] { recorder_->history(row); });
  }
  void frame(const Frame& frame) override {
    told([&] { recorder_->frame(frame); });
  }
  void checkpoint(const State& state) override {
    told([&] { recorder_->checkpoint(state); });
  }
  void progress(const State& state, Index phase, double fraction) override {
    limits_.progress(state, phase, fraction);
  }
  void end(const RunReport& report) override {
    told([&] { recorder_->end(report); });
  }

  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  template <class Call>
  void told(Call&& call) {
    if (!recorder_) return;
    try {
      call();
    } catch (...) {
      if (!failure_) failure_ = std::current_exception();
      throw;
    }
  }

  RunLimits& limits_;
  Observer* recorder_;
  std::exception_ptr failure_;
};

std::optional<State> net_state(const Mission& mission) {
  if (mission.net.state.empty()) return std::nullopt;
  return read_checkpoint(std::filesystem::path(mission.folder) / mission.net.state);
}

void refuse(RunRecord& record, const std::string& why) {
  record.outcome = "refused";
  record.reason = why;
}

void take(RunRecord& record, const RunReport& report, const RunLimits& limits,
          const LimitSpec& spec) {
  record.outcome = to_string(report.outcome);
  record.reason = report.reason;
  record.measures = report.measures;
  if (report.outcome == Outcome::interrupted) {
    record.outcome = "limit";
    record.reason = limits.text();
  }
  clean_measures(record);
  if (report.outcome != Outcome::finished && report.outcome != Outcome::broke)
    record.success.reset();
  if (limits.reached() == Reached::wall_clock && report.outcome == Outcome::interrupted)
    set_timeout(record, spec);
}

}  // namespace

RunRecord planned_record(const Campaign& campaign, std::int64_t id) {
  const PlannedRun run = campaign.plan().run(id);
  RunRecord record;
  record.id = id;
  record.seed = run.seed;
  record.inputs = run.inputs;
  record.versions = campaign.identity().program;
  record.command = campaign.command(id);
  record.host = host_name();
  record.started = utc_now();
  return record;
}

std::optional<RunRecord> execute_run(const Campaign& campaign, std::int64_t id,
                                     const RecorderMaker& make_recorder,
                                     const std::atomic<bool>* stop) {
  const auto started = std::chrono::steady_clock::now();
  RunRecord record = planned_record(campaign, id);
  const auto finish = [&] {
    record.wall_time =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    return record;
  };
  std::optional<Mission> mission;
  std::optional<MissionModel> model;
  RunOptions options;
  try {
    mission = campaign.mission(campaign.plan().run(id));
    options.net_state = net_state(*mission);
    check_memory(estimate(*mission));
    model.emplace(*mission);
    check_run(*mission, *model, options);
  } catch (const Error& error) {
    refuse(record, error.what());
    return finish();
  } catch (const std::bad_alloc&) {
    refuse(record, "there is not enough memory to build it");
    return finish();
  }
  RunLimits limits(campaign.spec().limits, stop);
  Watched watched(limits, make_recorder(*mission));
  options.stop = &limits.stopping();
  RunReport report;
  try {
    report = run_mission(*mission, *model, watched, options);
  } catch (const Error& error) {
    watched.rethrow();
    report.outcome = Outcome::failed;
    report.reason = error.what();
  }
  watched.rethrow();
  if (limits.reached() == Reached::outside) return std::nullopt;
  take(record, report, limits, campaign.spec().limits);
  return finish();
}

std::optional<RunRecord> execute_and_keep(const Campaign& campaign, std::int64_t id,
                                          const std::filesystem::path& folder,
                                          const std::atomic<bool>* stop) {
  std::optional<KeptResults> kept;
  const auto make_recorder = [&](const Mission& mission) {
    kept.emplace(campaign.spec().keep, id, folder, mission);
    return kept->recorder();
  };
  std::optional<RunRecord> record = execute_run(campaign, id, make_recorder, stop);
  if (record && kept) record->kept = kept->settle(record->success.value_or(false));
  return record;
}

void clean_measures(RunRecord& record) {
  Measures kept;
  for (Measure& measure : record.measures) {
    if (measure.name == "wall_time") continue;
    if (measure.name == "success") {
      if (const bool* value = std::get_if<bool>(&measure.value)) record.success = *value;
      continue;
    }
    const double* number = std::get_if<double>(&measure.value);
    if (number && !std::isfinite(*number)) {
      if (!record.missing.empty()) record.missing += "; ";
      record.missing += fmt::format("{} came out as {}", measure.name, *number);
      measure.value = std::monostate{};
    }
    kept.push_back(std::move(measure));
  }
  record.measures = std::move(kept);
}

void set_timeout(RunRecord& record, const LimitSpec& limits) {
  record.outcome = "timeout";
  record.reason = fmt::format("it reached the limit of {:.6g} s of wall clock", limits.wall_clock);
  // How far it came depends on the machine.
  record.measures.clear();
  record.missing.clear();
  record.success.reset();
}

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

std::string utc_now() {
  return fmt::format(
      "{:%Y-%m-%dT%H:%M:%SZ}",
      fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
}

}  // namespace retiarius
