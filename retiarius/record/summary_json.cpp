#include "retiarius/record/summary_json.hpp"

#include <array>
#include <cmath>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "retiarius/base/error.hpp"
#include "retiarius/motion/integrator.hpp"
#include "retiarius/record/file.hpp"

namespace retiarius {

namespace {

using Json = nlohmann::ordered_json;

// JSON knows neither NaN nor infinity: both are null, as is a measure that does not apply.
Json to_json(const Measure& measure) {
  if (const double* number = std::get_if<double>(&measure.value))
    return std::isfinite(*number) ? Json(*number) : Json(nullptr);
  if (const std::int64_t* count = std::get_if<std::int64_t>(&measure.value)) return *count;
  if (const bool* truth = std::get_if<bool>(&measure.value)) return *truth;
  return nullptr;
}

Json to_json(const Measures& measures) {
  Json object = Json::object();
  for (const Measure& measure : measures) object[measure.name] = to_json(measure);
  return object;
}

Json to_json(const std::vector<std::pair<std::string, std::string>>& pairs) {
  Json object = Json::object();
  for (const auto& [name, value] : pairs) object[name] = value;
  return object;
}

Json phases_json(const std::vector<PhaseReport>& phases) {
  Json list = Json::array();
  for (const PhaseReport& phase : phases) {
    Json entry;
    entry["name"] = phase.name;
    entry["kind"] = phase_kind_name(phase.kind);
    entry["start"] = phase.start;
    entry["end"] = phase.end;
    entry["trigger"] = phase.trigger;
    entry["measures"] = to_json(phase.measures);
    list.push_back(std::move(entry));
  }
  return list;
}

Json units_json(const RunReport& report) {
  Json units = Json::object();
  const auto add = [&](const Measures& measures) {
    for (const Measure& measure : measures)
      if (!measure.unit.empty()) units[measure.name] = measure.unit;
  };
  add(report.measures);
  for (const PhaseReport& phase : report.phases) add(phase.measures);
  return units;
}

std::string iso_time(std::chrono::system_clock::time_point time) {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}",
                     fmt::gmtime(std::chrono::system_clock::to_time_t(time)));
}

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

}  // namespace

const char* phase_kind_name(PhaseKind kind) {
  switch (kind) {
    case PhaseKind::free:
      return "free";
    case PhaseKind::fold:
      return "fold";
    case PhaseKind::shoot:
      return "shoot";
    case PhaseKind::spread:
      return "spread";
    case PhaseKind::contact:
      return "contact";
    case PhaseKind::close:
      return "close";
  }
  throw Error("a phase of unknown kind");
}

namespace {

// Of the phases whose mission leaves something to be chosen.
Json choices_json(const std::vector<PhaseChoice>& choices) {
  Json list = Json::array();
  for (const auto& [phase, choice] : choices) {
    Json one = {{"phase", phase}};
    if (!choice.method_reason.empty())
      one["integrator"] = {{"taken", to_string(choice.method)}, {"reason", choice.method_reason}};
    if (!choice.solver_reason.empty())
      one["solver"] = {{"taken", to_string(choice.solver)}, {"reason", choice.solver_reason}};
    if (one.size() > 1) list.push_back(std::move(one));
  }
  return list;
}

}  // namespace

std::string summary_text(const RunModel& model, const RunReport& report, const BuildInfo& build,
                         const Timings& timings) {
  Json summary;
  summary["format"] = 1;
  summary["title"] = model.mission ? Json(model.mission->title) : Json(nullptr);
  summary["outcome"] = to_string(report.outcome);
  summary["reason"] = report.reason;
  summary["phases"] = phases_json(report.phases);
  summary["measures"] = to_json(report.measures);
  summary["units"] = units_json(report);
  summary["seed"] = model.mission ? Json(model.mission->seed) : Json(nullptr);
  summary["chosen"] = choices_json(model.choices);
  summary["start_report"] = model.start_report;
  Json& versions = summary["versions"];
  versions["retiarius"] = build.version;
  versions["revision"] = build.revision;
  versions["compiler"] = build.compiler;
  versions["libraries"] = to_json(build.libraries);
  summary["options"] = to_json(build.options);
  summary["options"]["build_type"] = build.build_type;
  summary["kernels"] = build.kernels;
  Json& clock = summary["timings"];
  clock["host"] = timings.host;
  clock["started"] = timings.started;
  clock["finished"] = timings.finished;
  clock["wall_seconds"] = timings.wall_seconds;
  Json& work = clock["work_seconds"];
  work["assembly"] = report.work.assembly;
  work["factorisation"] = report.work.factor;
  work["solution"] = report.work.solve;
  work["contact"] = report.work.contact;
  work["contact_search"] = report.work.search;
  // Text from outside may hold bytes that are not UTF-8: they are replaced, never fatal.
  return summary.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

SummaryJson::SummaryJson(const std::filesystem::path& folder, BuildInfo build)
    : path_(folder / "summary.json"),
      build_(std::move(build)),
      started_(std::chrono::system_clock::now()) {}

void SummaryJson::begin(const RunModel& model) { model_ = model; }

void SummaryJson::end(const RunReport& report) {
  const auto finished = std::chrono::system_clock::now();
  const Timings timings{host_name(), iso_time(started_), iso_time(finished),
                        std::chrono::duration<double>(finished - started_).count()};
  write_atomically(path_, summary_text(model_, report, build_, timings));
}

}  // namespace retiarius
