#include "retiarius/report/read_report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "retiarius/base/error.hpp"
#include "retiarius/record/file.hpp"
#include "retiarius/record/replay_chunk.hpp"
#include "retiarius/record/replay_header.hpp"
#include "retiarius/record/run_file.hpp"
#include "retiarius/record/summary_json.hpp"
#include "retiarius/report/report_recorder.hpp"

namespace retiarius {

namespace {

using Json = nlohmann::ordered_json;

Outcome outcome_named(const std::string& name) {
  for (Outcome o : {Outcome::finished, Outcome::failed, Outcome::interrupted, Outcome::broke})
    if (name == to_string(o)) return o;
  throw Error(fmt::format("outcome '{}' is none of finished, failed, interrupted, broke", name));
}

PhaseKind kind_named(const std::string& name) {
  for (PhaseKind k : {PhaseKind::free, PhaseKind::fold, PhaseKind::shoot, PhaseKind::spread,
                      PhaseKind::contact, PhaseKind::close})
    if (name == phase_kind_name(k)) return k;
  throw Error(fmt::format("phase kind '{}' is unknown", name));
}

Measures measures_of(const Json& object, const Json& units) {
  Measures measures;
  for (const auto& [name, value] : object.items()) {
    Measure measure{name, units.value(name, ""), {}};
    if (value.is_boolean())
      measure.value = value.get<bool>();
    else if (value.is_number_integer())
      measure.value = value.get<std::int64_t>();
    else if (value.is_number())
      measure.value = value.get<double>();
    measures.push_back(std::move(measure));
  }
  return measures;
}

std::vector<std::pair<std::string, std::string>> pairs_of(const Json& object) {
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const auto& [name, value] : object.items())
    pairs.emplace_back(name, value.get<std::string>());
  return pairs;
}

void take_summary(const Json& summary, ReportData& data) {
  const Json& units = summary.at("units");
  if (summary.at("title").is_string()) data.title = summary.at("title").get<std::string>();
  if (summary.at("seed").is_number()) data.seed = summary.at("seed").get<std::uint64_t>();
  data.start_report = summary.at("start_report").get<std::string>();
  data.run.outcome = outcome_named(summary.at("outcome").get<std::string>());
  data.run.reason = summary.at("reason").get<std::string>();
  data.run.measures = measures_of(summary.at("measures"), units);
  for (const Json& phase : summary.at("phases"))
    data.run.phases.push_back(
        {phase.at("name").get<std::string>(), kind_named(phase.at("kind").get<std::string>()),
         phase.at("start").get<double>(), phase.at("end").get<double>(),
         phase.at("trigger").get<std::string>(), measures_of(phase.at("measures"), units)});
  data.build.version = summary.at("versions").at("retiarius").get<std::string>();
  data.build.compiler = summary.at("versions").at("compiler").get<std::string>();
  data.build.libraries = pairs_of(summary.at("versions").at("libraries"));
  data.build.options = pairs_of(summary.at("options"));
  data.build.build_type = summary.at("options").at("build_type").get<std::string>();
  std::erase_if(data.build.options, [](const auto& o) { return o.first == "build_type"; });
  data.build.kernels = summary.at("kernels").get<std::string>();
}

void read_summary(const std::filesystem::path& path, ReportData& data) {
  if (!std::filesystem::exists(path)) {
    data.run.outcome = Outcome::interrupted;
    data.run.reason = "the run did not come to its end: there is no summary.json";
    return;
  }
  const std::string text = read_whole_file(path);
  try {
    take_summary(Json::parse(text), data);
  } catch (const Json::exception& error) {
    throw InputError(fmt::format("cannot use {}: {}", path.string(), error.what()));
  } catch (const Error& error) {
    throw InputError(fmt::format("cannot use {}: {}", path.string(), error.what()));
  }
}

void read_history(const RunFile& file, ReportData& data) {
  data.columns = file.history_names();
  for (const std::string& name : data.columns) {
    const std::vector<double> column = file.history(name);
    data.rows.resize(column.size());
    for (std::size_t r = 0; r < column.size(); ++r) data.rows[r].push_back(column[r]);
  }
}

std::string recorded_title(const std::filesystem::path& path) {
  try {
    const std::string bytes = read_whole_file(path);
    const ReplayChunks recording = read_chunks(bytes);
    if (recording.chunks.empty()) throw InputError("it ends before its header");
    const ReplayHeader header = read_replay_header(recording.chunks[0].content);
    return Json::parse(header.text).at("title").get<std::string>();
  } catch (const Json::exception& error) {
    throw InputError(fmt::format("cannot use {}: {}", path.string(), error.what()));
  } catch (const InputError& error) {
    throw InputError(fmt::format("cannot use {}: {}", path.string(), error.what()));
  }
}

}  // namespace

ReportData read_outcome(const std::filesystem::path& folder) {
  ReportData data;
  read_summary(folder / "summary.json", data);
  if (data.title.empty()) data.title = recorded_title(folder / "replay.bin");
  return data;
}

ReportData read_report(const std::filesystem::path& folder) {
  ReportData data;
  read_summary(folder / "summary.json", data);
  const RunFile file(folder / "run.h5");
  if (data.title.empty()) data.title = file.title();
  data.resolved = file.resolved();
  read_history(file, data);
  data.scene = make_scene(file.net(), file.perimeter(), file.bodies());
  Pictures pictures;
  for (std::size_t k = 0; k < file.frame_count(); ++k) {
    const FrameData f = file.frame(k);
    pictures.add(make_picture(data.scene, f.time, f.phase, f.x, f.bodies));
  }
  data.pictures = pictures.chosen();
  return data;
}

}  // namespace retiarius
