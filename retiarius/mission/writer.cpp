#include "retiarius/mission/writer.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "retiarius/mission/schema.hpp"

namespace retiarius {

namespace {

class Writer {
 public:
  explicit Writer(const Mission& mission) : mission_(mission) {}

  std::string write() {
    keys(mission_table(), mission_);
    table("[net]", net_table(), mission_.net);
    table("[net.thread]", thread_table(), mission_.net.thread);
    table("[net.border]", border_table(), mission_.net.border);
    table("[net.corner_mass]", corner_mass_table(), mission_.net.corner_mass);
    for (const BodySpec& body : mission_.targets) table("[[target]]", target_table(), body);
    settings("", mission_);
    for (const PhaseSpec& phase : mission_.phases) {
      table("[[phase]]", phase_table(), phase);
      settings("phase.", phase);
      for (const MoveSpec& move : phase.move) table("[[phase.move]]", move_table(), move);
    }
    for (const ProbeSpec& probe : mission_.probes) table("[[probe]]", probe_table(), probe);
    table("[output]", output_table(), mission_.output);
    return out_;
  }

 private:
  template <class Spec>
  void settings(const std::string& prefix, const Spec& spec) {
    table("[" + prefix + "environment]", environment_table(), spec.environment);
    table("[" + prefix + "integrator]", integrator_table(), spec.integrator);
    table("[" + prefix + "contact]", contact_table(), spec.contact);
  }

  template <class Spec>
  void table(const std::string& heading, const Table<Spec>& schema, const Spec& spec) {
    out_ += "\n" + heading + "\n";
    keys(schema, spec);
  }

  template <class Spec>
  void keys(const Table<Spec>& schema, const Spec& spec) {
    for (const auto& [info, value] : schema.values(spec)) line(*info, value);
  }

  void line(const KeyInfo& key, const KeyValue& value) {
    if (std::holds_alternative<std::monostate>(value)) {
      out_ += fmt::format("# {}: {}\n", key.name, key.default_text);
      return;
    }
    std::string text = value_text(value);
    if (key.path && !std::get<std::string>(value).empty()) {
      const auto full = std::filesystem::path(mission_.folder) / std::get<std::string>(value);
      text = quoted(std::filesystem::absolute(full).lexically_normal().string());
    }
    out_ += fmt::format("{} = {}", key.name, text);
    if (!key.unit.empty()) out_ += "  # " + key.unit;
    out_ += "\n";
  }

  const Mission& mission_;
  std::string out_;
};

}  // namespace

std::string to_toml(const Mission& mission) { return Writer(mission).write(); }

}  // namespace retiarius
