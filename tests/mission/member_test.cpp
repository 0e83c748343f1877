// Holds the structs of a mission and the schema together.
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "retiarius/mission/schema.hpp"

namespace retiarius {
namespace {

using Lines = std::vector<std::string>;

// A new member of a struct does not compile here until it is listed, and fails until it has a key.
Lines members(const NetSpec& spec) {
  [[maybe_unused]] const auto& [pattern, sides, side, mesh, cell, segments, knots, knot_mass, scale,
                                zigzag, disturbance, file, state, position, thread, border,
                                corner_mass] = spec;
  return {"pattern",   "sides", "side",   "mesh",        "cell", "segments", "knots",
          "knot_mass", "scale", "zigzag", "disturbance", "file", "state",    "position"};
}
Lines members(const ThreadSpec& spec) {
  [[maybe_unused]] const auto& [a, b, c, d, e, f, g, h] = spec;
  return {"young_modulus",     "density",     "radius",           "bending",
          "bending_stiffness", "compression", "material_damping", "strength"};
}
Lines members(const BorderSpec& spec) {
  [[maybe_unused]] const auto& [a, b, c, d, e] = spec;
  return {"young_modulus", "density", "radius", "bending_stiffness", "strength"};
}
Lines members(const CornerMassSpec& spec) {
  [[maybe_unused]] const auto& [mass, bridle, bridle_segments] = spec;
  return {"mass", "bridle", "bridle_segments"};
}
Lines members(const BodySpec& spec) {
  [[maybe_unused]] const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p] = spec;
  return {"name",         "shape",    "radius",   "length",  "size",   "file",
          "scale",        "mass",     "density",  "inertia", "motion", "position",
          "attitude_deg", "velocity", "spin_deg", "friction"};
}
Lines members(const EnvironmentSpec& spec) {
  [[maybe_unused]] const auto& [gravity, damping] = spec;
  return {"gravity", "damping"};
}
Lines members(const IntegratorSpec& spec) {
  [[maybe_unused]] const auto& [method, step, substep, tolerance, solver, rho, adaptive, accuracy,
                                min_step, max_iterations, max_halvings] = spec;
  return {"method",   "step",     "substep",  "tolerance",      "solver",      "rho",
          "adaptive", "accuracy", "min_step", "max_iterations", "max_halvings"};
}
Lines members(const ContactSpec& spec) {
  [[maybe_unused]] const auto& [method, friction, self, thread_friction, gap, stick_speed,
                                friction_rounds, friction_tolerance] = spec;
  return {"method",          "friction",          "self", "thread_friction", "gap", "stick_speed",
          "friction_rounds", "friction_tolerance"};
}
Lines members(const PhaseSpec& spec) {
  [[maybe_unused]] const auto& [kind, name, fix, until, move, speed, half_angle_deg, delay, axis,
                                grips, grip_spacing, ratio, duration, path, distance, radius,
                                close_speed, environment, integrator, contact, place] = spec;
  return {"kind",  "name",         "fix",   "until",    "speed", "half_angle_deg", "delay", "axis",
          "grips", "grip_spacing", "ratio", "duration", "path",  "distance",       "radius"};
}
Lines members(const MoveSpec& spec) {
  [[maybe_unused]] const auto& [nodes, displacement, velocity, duration] = spec;
  return {"nodes", "displacement", "velocity", "duration"};
}
Lines members(const ProbeSpec& spec) {
  [[maybe_unused]] const auto& [name, node, place] = spec;
  return {"name", "node"};
}
Lines members(const OutputSpec& spec) {
  [[maybe_unused]] const auto& [interval, frame_interval, every_step] = spec;
  return {"interval", "frame_interval", "every_step"};
}
Lines members(const Mission& spec) {
  [[maybe_unused]] const auto& [title, seed, net, targets, environment, integrator, contact, phases,
                                probes, output, file, folder] = spec;
  return {"title", "seed"};
}

template <class Spec>
void expect_keys(const Table<Spec>& table, const std::set<std::string>& constant = {}) {
  std::set<std::string> keys;
  for (const auto& k : table.keys) keys.insert(k.name);
  for (const auto& name : constant) EXPECT_EQ(keys.erase(name), 1u) << name;
  const Lines names = members(Spec{});
  EXPECT_EQ(keys, std::set<std::string>(names.begin(), names.end())) << table.info.path;
}

TEST(Schema, EveryMemberHasAKey) {
  expect_keys(mission_table(), {"format"});
  expect_keys(net_table());
  expect_keys(thread_table());
  expect_keys(border_table());
  expect_keys(corner_mass_table());
  expect_keys(target_table());
  expect_keys(environment_table());
  expect_keys(integrator_table());
  expect_keys(contact_table());
  expect_keys(phase_table());
  expect_keys(move_table());
  expect_keys(probe_table());
  expect_keys(output_table());
}

}  // namespace
}  // namespace retiarius
