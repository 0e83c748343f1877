#include "retiarius/check/checked_run.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include "retiarius/base/error.hpp"

namespace retiarius::check {
namespace {

// contact.self of each phase: its own, else the mission's.
std::vector<bool> self_of_phases(const toml::table& mission) {
  const bool common = mission["contact"]["self"].value_or(false);
  std::vector<bool> list;
  if (const toml::array* phases = mission["phase"].as_array()) {
    for (const toml::node& phase : *phases)
      list.push_back(toml::node_view(phase)["contact"]["self"].value_or(common));
  }
  return list;
}

ShapeKind shape_named(const std::string& name) {
  const std::pair<const char*, ShapeKind> kNames[] = {
      {"sphere", ShapeKind::sphere},   {"box", ShapeKind::box},   {"cylinder", ShapeKind::cylinder},
      {"capsule", ShapeKind::capsule}, {"cone", ShapeKind::cone}, {"plane", ShapeKind::plane},
      {"mesh", ShapeKind::mesh}};
  for (const auto& [known, kind] : kNames)
    if (name == known) return kind;
  throw InputError("the recorded mission has a body of unknown shape \"" + name + "\"");
}

// Shape and sizes; no file is sought, so that a run may be checked where its mission is not.
BodySpec body_of(const toml::table& target) {
  BodySpec spec;
  spec.shape = shape_named(target["shape"].value_or(std::string()));
  spec.radius = target["radius"].value_or(0.0);
  spec.length = target["length"].value_or(0.0);
  for (int k = 0; k < 3; ++k)
    spec.size[k] = target["size"][static_cast<std::size_t>(k)].value_or(0.0);
  return spec;
}

std::vector<BodySpec> bodies_of(const toml::table& mission) {
  std::vector<BodySpec> list;
  if (const toml::table* only = mission["target"].as_table()) list.push_back(body_of(*only));
  if (const toml::array* targets = mission["target"].as_array()) {
    for (const toml::node& target : *targets)
      if (const toml::table* table = target.as_table()) list.push_back(body_of(*table));
  }
  return list;
}

toml::table parsed(const std::string& resolved, const std::filesystem::path& folder) {
  try {
    return toml::parse(resolved);
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("{}: the recorded mission cannot be read: {}", folder.string(),
                                 error.description()));
  }
}

}  // namespace

CheckedRun::CheckedRun(const std::filesystem::path& folder) : file(folder / "run.h5") {
  segments = file.net().segments;
  radius = file.segment_radius();
  rest_length = file.rest_length();
  const toml::table mission = parsed(file.resolved(), folder);
  const std::vector<BodySpec> specs = bodies_of(mission);
  const std::vector<BodyDrawing> drawings = file.bodies();
  if (drawings.size() != specs.size())
    throw InputError(fmt::format("{}: the run has {} bodies, its mission {}", folder.string(),
                                 drawings.size(), specs.size()));
  for (std::size_t k = 0; k < drawings.size(); ++k) {
    names.push_back(drawings[k].name);
    solids.push_back(checked_solid(specs[k], drawings[k].mesh));
  }
  self = self_of_phases(mission);
}

}  // namespace retiarius::check
