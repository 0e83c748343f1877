#include "retiarius/campaign/campaign.hpp"

#include <sstream>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "retiarius/base/build_info.hpp"
#include "retiarius/base/instruction_set.hpp"
#include "retiarius/base/random.hpp"
#include "retiarius/campaign/read_campaign.hpp"
#include "retiarius/mission/reader.hpp"
#include "retiarius/mission/schema.hpp"
#include "retiarius/mission/set_override.hpp"
#include "retiarius/mission/toml_file.hpp"
#include "retiarius/record/file.hpp"

namespace retiarius {

namespace fs = std::filesystem;

namespace {

const TomlFileKind kMissionFile{"mission", "the campaign needs a whole mission"};

// 128 bits that tell texts apart, as 32 hexadecimal digits; not meant against forgery.
std::string hash(const std::string& text) {
  std::uint64_t a = text.size(), b = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    a = random_bits(a, 1, byte);
    b = random_bits(b, 2, byte);
  }
  return fmt::format("{:016x}{:016x}", a, b);
}

std::string formatted(const toml::table& root) {
  std::ostringstream text;
  text << toml::toml_formatter(root);
  return text.str();
}

// The bytes of a file that the mission names; one that cannot be read is the run's to report.
std::string bytes_of(const fs::path& path) {
  try {
    return read_whole_file(path);
  } catch (const Error&) {
    return "missing";
  }
}

std::string named_files(const Mission& mission) {
  std::string all;
  const auto add = [&](const std::string& name) {
    if (!name.empty()) all += hash(bytes_of(fs::path(mission.folder) / name));
  };
  add(mission.net.file);
  add(mission.net.state);
  for (const BodySpec& body : mission.targets) add(body.file);
  return all;
}

std::string program_text() {
  const BuildInfo& build = build_info();
  std::string options;
  for (const auto& [name, value] : build.options) options += fmt::format(" {}={}", name, value);
  return fmt::format("retiarius {} {}, {} {}{}, kernels {}", build.version, build.revision,
                     build.compiler, build.build_type, options, kernel_name());
}

// A text that a shell takes as one word.
std::string shell_word(const std::string& text) {
  const bool plain = text.find_first_not_of(
                         "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                         "0123456789_-./+=:@,") == std::string::npos;
  if (plain && !text.empty()) return text;
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

}  // namespace

std::string CampaignIdentity::text() const {
  return fmt::format("{} {} {}", campaign, mission, hash(program));
}

Campaign::Campaign(const std::string& path) : spec_(read_campaign(path)) {
  mission_file_ = spec_.mission_path();
  mission_folder_ = fs::path(mission_file_).parent_path().string();
  mission_text_ = read_toml_file(mission_file_, kMissionFile);
  toml::table root = parse_toml(mission_text_, mission_file_, kMissionFile);
  Mission base;
  try {
    for (const std::string& text : spec_.sets) apply_override(root, text);
    base = parse_mission(mission_text_, mission_file_, mission_folder_, spec_.sets);
  } catch (const InputError& error) {
    if (spec_.sets.empty() || std::string(error.what()).rfind("--set ", 0) != 0) throw;
    throw InputError(spec_.sets_place, fmt::format("set: {}", error.what()));
  }
  check_variables();
  plan_ = std::make_unique<CampaignPlan>(spec_);
  try {
    set_kernels(spec_.kernels);
  } catch (const Error& error) {
    throw InputError(SourcePlace{path, 0, 0}, fmt::format("kernels: {}", error.what()));
  }
  identity_.campaign = hash(spec_.canonical);
  identity_.mission = hash(formatted(root) + named_files(base));
  identity_.program = program_text();
}

// Whether the mission has what the variables set. The values themselves are each run's own.
void Campaign::check_variables() const {
  for (std::size_t i = 0; i < spec_.variables.size(); ++i) {
    const VariableSpec& variable = spec_.variables[i];
    for (const std::string& path : variable.sets) {
      toml::table root = parse_toml(mission_text_, mission_file_, kMissionFile);
      for (const std::string& text : spec_.sets) apply_override(root, text);
      const std::string tried = path + (variable.dimensions() > 1 ? "=[0.0, 0.0, 1.0]" : "=1.0");
      try {
        apply_override(root, tried);
      } catch (const InputError& error) {
        std::string why = error.what();
        const std::string prefix = "--set " + tried + ": ";
        if (why.rfind(prefix, 0) == 0) why = why.substr(prefix.size());
        throw InputError(variable.place,
                         fmt::format("variable[{}].set = {}: {}", i, quoted(path), why));
      }
    }
  }
}

Mission Campaign::mission(const PlannedRun& run) const {
  std::vector<std::string> overrides = spec_.sets;
  overrides.insert(overrides.end(), run.overrides.begin(), run.overrides.end());
  Mission mission = parse_mission(mission_text_, mission_file_, mission_folder_, overrides);
  mission.file = mission_file_;
  return mission;
}

std::string Campaign::command(std::int64_t id) const {
  const std::string file = fs::absolute(spec_.file).lexically_normal().string();
  return fmt::format("retiarius campaign replay {} --id {}", shell_word(file), id);
}

}  // namespace retiarius
