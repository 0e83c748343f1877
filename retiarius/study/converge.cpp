#include "retiarius/study/converge.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"

namespace retiarius {

namespace {

// Keeps the history, and hands everything on to another observer.
class HistoryKeeper final : public Observer {
 public:
  HistoryKeeper(std::vector<HistoryRow>& rows, Observer* other) : rows_(rows), other_(other) {}

  void begin(const RunModel& model) override {
    if (other_) other_->begin(model);
  }
  void history(const HistoryRow& row) override {
    rows_.push_back(row);
    if (other_) other_->history(row);
  }
  void frame(const Frame& frame) override {
    if (other_) other_->frame(frame);
  }
  void save(const Checkpoint& saved, bool durable) override {
    if (other_) other_->save(saved, durable);
  }
  void progress(const State& state, Index phase, double fraction) override {
    if (other_) other_->progress(state, phase, fraction);
  }
  void end(const RunReport& report) override {
    if (other_) other_->end(report);
  }

 private:
  std::vector<HistoryRow>& rows_;
  Observer* other_;
};

void run_into(LevelResult& result, const Level& level, const RunOptions& options, Observer* watch) {
  const MissionModel model(level.mission);
  HistoryKeeper keeper(result.rows, watch);
  const RunReport report = run_mission(level.mission, model, keeper, options);
  result.outcome = report.outcome;
  result.reason = report.reason;
  if (result.usable()) result.quantities = run_quantities(level.mission, report, result.rows);
}

LevelResult run_level(const Plan& plan, std::size_t k, const ConvergeOptions& options) {
  RunOptions run;
  run.stop = options.stop;
  run.net_state = options.net_state;
  run.log = options.log;
  LevelResult result;
  const auto start = std::chrono::steady_clock::now();
  try {
    run_into(result, plan.levels[k], run, options.watch ? options.watch(k) : nullptr);
  } catch (const Error& error) {
    if (k == 0) throw;  // the mission as given does not fit: nothing to study
    result.outcome = Outcome::failed;
    result.reason = error.what();
  }
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  result.wall_time = wall.count();
  return result;
}

// The names of all quantities of a series, in the order of the first level that has them.
std::vector<Trend> empty_trends(const Series& series, const std::vector<LevelResult>& levels) {
  std::vector<Trend> trends;
  for (std::size_t level : series.levels)
    for (const Quantity& q : levels[level].quantities) {
      const auto at = std::find_if(trends.begin(), trends.end(),
                                   [&](const Trend& t) { return t.name == q.name; });
      if (at == trends.end())
        trends.push_back({q.name, q.unit, q.size, {}, {}});
      else
        at->size = std::max(at->size, q.size);
    }
  return trends;
}

SeriesResult follow(const Series& series, const std::vector<LevelResult>& levels,
                    double tolerance) {
  SeriesResult result{empty_trends(series, levels)};
  for (Trend& trend : result.trends) {
    std::vector<double> judged;
    for (std::size_t level : series.levels) {
      const Quantity* q = find_quantity(levels[level].quantities, trend.name);
      trend.values.push_back(q ? q->value : NAN);
      // A level without result says nothing; at the fine end it is as if it had not been asked.
      judged.push_back(trend.values.back());
    }
    for (std::size_t k = series.levels.size(); k-- > 0 && !levels[series.levels[k]].usable();)
      judged.pop_back();
    trend.judgement = judge(judged, trend.size, tolerance);
  }
  // What applies to no level, such as a contact that never is.
  std::erase_if(result.trends, [](const Trend& trend) {
    return std::none_of(trend.values.begin(), trend.values.end(),
                        [](double v) { return std::isfinite(v); });
  });
  return result;
}

}  // namespace

std::size_t SeriesResult::count(Verdict verdict) const {
  return static_cast<std::size_t>(std::count_if(trends.begin(), trends.end(), [&](const Trend& t) {
    return t.judgement.verdict == verdict;
  }));
}

std::string SeriesResult::summary(double tolerance) const {
  std::string text = fmt::format("{} of {} quantities hold at {:.3g} %, {} do not, {} are chaotic",
                                 count(Verdict::holds), trends.size(), 100.0 * tolerance,
                                 count(Verdict::does_not_hold), count(Verdict::chaotic));
  if (const std::size_t unknown = count(Verdict::unknown))
    text += fmt::format("; of {} nobody knows: too few levels came to their end", unknown);
  return text;
}

Study converge(const Plan& plan, const ConvergeOptions& options) {
  Study study;
  study.plan = plan;
  study.tolerance = options.tolerance;
  for (std::size_t k = 0; k < plan.levels.size(); ++k) {
    study.interrupted = study.interrupted || (options.stop && options.stop->load());
    if (study.interrupted) {
      LevelResult none;
      none.outcome = Outcome::interrupted;
      none.reason = "not begun";
      study.levels.push_back(none);
      continue;
    }
    study.levels.push_back(run_level(plan, k, options));
    study.interrupted = study.levels.back().outcome == Outcome::interrupted;
  }
  for (const Series& series : plan.series)
    study.series.push_back(follow(series, study.levels, options.tolerance));
  return study;
}

}  // namespace retiarius
