#include "retiarius/mission/reader.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "retiarius/mission/check.hpp"
#include "retiarius/mission/schema.hpp"
#include "retiarius/mission/set_override.hpp"
#include "retiarius/mission/table_source.hpp"
#include "retiarius/mission/toml_file.hpp"
#include "retiarius/mission/trigger.hpp"

namespace retiarius {

namespace {

const TomlFileKind kMissionFile{"mission",
                                "a mission needs at least [net], [net.thread] and a "
                                "[[phase]]"};

// Where the characters of a one-line string begin, after its quote; column 0 where escapes or
// several lines leave columns inside the string without meaning.
SourcePlace inside_quotes(SourcePlace place, const std::string& value, const std::string& text) {
  if (place.line == 0) return place;
  std::size_t at = 0;
  for (int line = 1; line < place.line && at != std::string::npos; ++line) {
    at = text.find('\n', at);
    if (at != std::string::npos) ++at;
  }
  for (int column = 1; at < text.size() && column < place.column; ++column) {
    do {
      ++at;
    } while (at < text.size() && (text[at] & 0xC0) == 0x80);
  }
  for (const int quotes : {1, 3}) {
    const std::size_t start = at + static_cast<std::size_t>(quotes);
    if (start <= text.size() && text.compare(start, value.size(), value) == 0) {
      place.column += quotes;
      return place;
    }
  }
  place.column = 0;
  return place;
}

class MissionReader {
 public:
  MissionReader(const toml::table& root, const std::string& name, const std::string& text)
      : text_(text), places_(name), root_(root, "", {name, 0, 0}, places_) {}

  Mission read(const std::string& folder) {
    Mission mission;
    mission.folder = folder;
    root_.read(mission_table(), mission);
    read_net(mission.net);
    read_targets(mission.targets);
    read_settings(root_, mission);
    read_phases(mission);
    read_probes(mission.probes);
    if (const auto output = root_.table("output")) output->read(output_table(), mission.output);
    check_mission(mission, places_);
    return mission;
  }

 private:
  void read_net(NetSpec& net) {
    const auto source = root_.table("net");
    if (!source) throw InputError(root_.place(), "net is missing: add a table [net]");
    source->read(net_table(), net);
    const auto thread = source->table("thread");
    if (!thread) {
      throw InputError(source->place(), "net.thread is missing: add a table [net.thread]");
    }
    thread->read(thread_table(), net.thread);
    if (const auto border = source->table("border")) border->read(border_table(), net.border);
    if (const auto mass = source->table("corner_mass")) {
      mass->read(corner_mass_table(), net.corner_mass);
    }
  }

  void read_targets(std::vector<BodySpec>& targets) {
    for (const TableSource& source : root_.tables("target", true)) {
      BodySpec& body = targets.emplace_back();
      source.read(target_table(), body);
      if (!body.name.empty()) continue;
      const std::size_t i = targets.size() - 1;
      body.name = i == 0 ? "target" : fmt::format("target{}", i);
    }
  }

  // The tables that a phase may override; what is not given stays.
  template <class Spec>
  void read_settings(const TableSource& source, Spec& spec) {
    if (const auto t = source.table("environment")) t->read(environment_table(), spec.environment);
    if (const auto t = source.table("integrator")) t->read(integrator_table(), spec.integrator);
    if (const auto t = source.table("contact")) t->read(contact_table(), spec.contact);
  }

  void read_phases(Mission& mission) {
    const auto sources = root_.tables("phase", false);
    if (sources.empty()) {
      throw InputError(root_.place(), "phase is missing: a mission needs at least one [[phase]]");
    }
    for (const TableSource& source : sources) {
      PhaseSpec& phase = mission.phases.emplace_back();
      phase.place = source.place();
      source.read(phase_table(), phase);
      phase.environment = mission.environment;
      phase.integrator = mission.integrator;
      phase.contact = mission.contact;
      read_settings(source, phase);
      for (const TableSource& move : source.tables("move", false)) {
        move.read(move_table(), phase.move.emplace_back());
      }
      const std::string until = source.path() + ".until";
      Trigger::parse(phase.until, inside_quotes(places_.of(until), phase.until, text_), until);
    }
    name_phases(mission.phases);
  }

  // "free", then "free2" for the second that bears no name.
  static void name_phases(std::vector<PhaseSpec>& phases) {
    std::set<std::string> taken;
    for (const PhaseSpec& phase : phases) taken.insert(phase.name);
    for (PhaseSpec& phase : phases) {
      if (!phase.name.empty()) continue;
      const std::string kind = phase_table().selected(phase);
      std::string name = kind;
      for (int i = 2; taken.count(name) > 0; ++i) name = fmt::format("{}{}", kind, i);
      taken.insert(name);
      phase.name = name;
    }
  }

  void read_probes(std::vector<ProbeSpec>& probes) {
    for (const TableSource& source : root_.tables("probe", false)) {
      ProbeSpec& probe = probes.emplace_back();
      probe.place = source.place();
      source.read(probe_table(), probe);
      if (probe.name.empty()) probe.name = probe.node;
    }
  }

  const std::string& text_;
  Places places_;
  TableSource root_;
};

}  // namespace

Mission parse_mission(const std::string& text, const std::string& name, const std::string& folder,
                      const std::vector<std::string>& overrides) {
  toml::table root = parse_toml(text, name, kMissionFile);
  for (const std::string& override_text : overrides) apply_override(root, override_text);
  return MissionReader(root, name, text).read(folder);
}

Mission read_mission(const std::string& path, const std::vector<std::string>& overrides) {
  const std::string text = read_toml_file(path, kMissionFile);
  const auto folder = std::filesystem::absolute(path).lexically_normal().parent_path();
  Mission mission = parse_mission(text, path, folder.string(), overrides);
  mission.file = path;
  return mission;
}

}  // namespace retiarius
