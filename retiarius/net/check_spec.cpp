#include "retiarius/net/check_spec.hpp"

#include <cmath>
#include <string>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"

namespace retiarius {
namespace {

constexpr double kDivisionTolerance = 1e-9;

[[noreturn]] void refuse(const char* key, double value, const char* allowed, const char* unit) {
  const std::string suffix = *unit ? fmt::format(" ({})", unit) : "";
  throw InputError(fmt::format("{} = {:.12g}: must be {}{}", key, value, allowed, suffix));
}

void positive(const char* key, double value, const char* unit) {
  if (!(value > 0.0) || !std::isfinite(value)) {
    refuse(key, value, std::isinf(value) ? "finite" : "greater than 0", unit);
  }
}

void not_negative(const char* key, double value, const char* unit) {
  if (!(value >= 0.0) || !std::isfinite(value)) {
    refuse(key, value, std::isinf(value) ? "finite" : "at least 0", unit);
  }
}

void at_least(const char* key, int value, int least) {
  if (value < least)
    throw InputError(fmt::format("{} = {}: must be at least {}", key, value, least));
}

void positive(const char* key, const std::optional<double>& value, const char* unit) {
  if (value) positive(key, *value, unit);
}

void not_negative(const char* key, const std::optional<double>& value, const char* unit) {
  if (value) not_negative(key, *value, unit);
}

void check_materials(const ThreadSpec& thread, const BorderSpec& border) {
  positive("net.thread.young_modulus", thread.young_modulus, "Pa");
  positive("net.thread.density", thread.density, "kg/m3");
  positive("net.thread.radius", thread.radius, "m");
  not_negative("net.thread.bending_stiffness", thread.bending_stiffness, "N m2");
  not_negative("net.thread.material_damping", thread.material_damping, "s");
  positive("net.thread.strength", thread.strength, "N");
  positive("net.border.young_modulus", border.young_modulus, "Pa");
  positive("net.border.density", border.density, "kg/m3");
  positive("net.border.radius", border.radius, "m");
  not_negative("net.border.bending_stiffness", border.bending_stiffness, "N m2");
  positive("net.border.strength", border.strength, "N");
}

void check_cell(const NetSpec& spec) {
  const char* name = spec.cell == Cell::square ? "square" : "diamond";
  switch (spec.pattern) {
    case Pattern::square:
      return;
    case Pattern::triangle:
      if (spec.cell != Cell::square) return;
      throw InputError("net.cell = \"square\": pattern = \"triangle\" allows natural or diamond");
    default:
      if (spec.cell == Cell::natural) return;
      throw InputError(fmt::format(
          "net.cell = \"{}\": only pattern = \"square\" and \"triangle\" have a choice of cells",
          name));
  }
}

void check_outline(const NetSpec& spec) {
  check_cell(spec);
  if (spec.pattern == Pattern::file) {
    if (spec.file.empty()) throw InputError("net.file: required with pattern = \"file\"");
    return;
  }
  if (spec.pattern == Pattern::polygon) at_least("net.sides", spec.sides, 3);
  positive("net.side", spec.side, "m");
  positive("net.mesh", spec.mesh, "m");
  pieces_per_side(spec);
}

}  // namespace

std::int64_t pieces_per_side(const NetSpec& spec) {
  const double ratio = spec.side / spec.mesh;
  const double n = std::round(ratio);
  if (n >= 1.0 && std::abs(n * spec.mesh - spec.side) <= kDivisionTolerance * spec.side) {
    if (n > 1e9) {
      throw InputError(
          fmt::format("net.mesh = {:.12g}: more than 1e9 pieces along net.side = {:.12g}",
                      spec.mesh, spec.side));
    }
    return static_cast<std::int64_t>(n);
  }
  const double coarser = std::floor(ratio);
  const std::string sizes = coarser < 1.0
                                ? fmt::format("the largest size that does is {:.12g}", spec.side)
                                : fmt::format("the nearest sizes that do are {:.12g} and {:.12g}",
                                              spec.side / (coarser + 1.0), spec.side / coarser);
  throw InputError(fmt::format("net.mesh = {:.12g}: must divide net.side = {:.12g}; {} (m)",
                               spec.mesh, spec.side, sizes));
}

void check_spec(const NetSpec& spec) {
  check_outline(spec);
  at_least("net.segments", spec.segments, 1);
  not_negative("net.knot_mass", spec.knot_mass, "kg");
  positive("net.scale", spec.scale, "");
  if (spec.zigzag && spec.scale > 1.0) {
    refuse("net.scale", spec.scale, "at most 1 with net.zigzag = true", "");
  }
  not_negative("net.disturbance", spec.disturbance, "m");
  if (!spec.position.allFinite()) throw InputError("net.position: must be finite (m)");
  check_materials(spec.thread, spec.border);
  not_negative("net.corner_mass.mass", spec.corner_mass.mass, "kg");
  not_negative("net.corner_mass.bridle", spec.corner_mass.bridle, "m");
  at_least("net.corner_mass.bridle_segments", spec.corner_mass.bridle_segments, 1);
}

}  // namespace retiarius
