#include "retiarius/net/check_spec.hpp"

#include <functional>
#include <limits>

#include "nets.hpp"

namespace retiarius {
namespace {

using namespace test;

std::string refusal(const std::function<void(NetSpec&)>& change) {
  NetSpec spec = net_of(Pattern::hexagon, 1.0, 0.2, 2);
  change(spec);
  const std::string message = error_of<InputError>([&] { check_spec(spec); });
  EXPECT_EQ(error_of<InputError>([&] { build_network(spec); }), message);
  EXPECT_EQ(error_of<InputError>([&] { count_network(spec); }), message);
  return message;
}

TEST(CheckSpec, Outline) {
  EXPECT_EQ(refusal([](NetSpec& s) { s.side = 0.0; }), "net.side = 0: must be greater than 0 (m)");
  EXPECT_EQ(refusal([](NetSpec& s) { s.mesh = -0.2; }),
            "net.mesh = -0.2: must be greater than 0 (m)");
  EXPECT_EQ(refusal([](NetSpec& s) { s.side = kInfinity; }), "net.side = inf: must be finite (m)");
  EXPECT_EQ(refusal([](NetSpec& s) { s.mesh = std::numeric_limits<double>::quiet_NaN(); }),
            "net.mesh = nan: must be greater than 0 (m)");
  EXPECT_EQ(refusal([](NetSpec& s) { s.pattern = Pattern::polygon, s.sides = 2; }),
            "net.sides = 2: must be at least 3");
  EXPECT_EQ(refusal([](NetSpec& s) { s.segments = 0; }), "net.segments = 0: must be at least 1");
  EXPECT_EQ(refusal([](NetSpec& s) { s.pattern = Pattern::file; }),
            "net.file: required with pattern = \"file\"");
}

TEST(CheckSpec, MeshMustDivideTheSide) {
  EXPECT_EQ(refusal([](NetSpec& s) { s.mesh = 0.3; }),
            "net.mesh = 0.3: must divide net.side = 1; the nearest sizes that do are 0.25 and "
            "0.333333333333 (m)");
  EXPECT_EQ(refusal([](NetSpec& s) { s.mesh = 1.5; }),
            "net.mesh = 1.5: must divide net.side = 1; the largest size that does is 1 (m)");
  EXPECT_EQ(refusal([](NetSpec& s) { s.mesh = 1e-12; }),
            "net.mesh = 1e-12: more than 1e9 pieces along net.side = 1");
  EXPECT_EQ(pieces_per_side(net_of(Pattern::square, 1.0, 0.333333333333)), 3);
  EXPECT_EQ(pieces_per_side(net_of(Pattern::square, 5.0, 0.2)), 25);
  EXPECT_THROW(pieces_per_side(net_of(Pattern::square, 1.0, 0.2 * (1 + 2e-9))), InputError);
  EXPECT_EQ(pieces_per_side(net_of(Pattern::square, 1.0, 0.2 * (1 + 5e-10))), 5);
}

TEST(CheckSpec, CellsThatAPatternDoesNotHave) {
  EXPECT_EQ(refusal([](NetSpec& s) { s.cell = Cell::diamond; }),
            "net.cell = \"diamond\": only pattern = \"square\" and \"triangle\" have a choice of "
            "cells");
  EXPECT_EQ(refusal([](NetSpec& s) { s.pattern = Pattern::triangle, s.cell = Cell::square; }),
            "net.cell = \"square\": pattern = \"triangle\" allows natural or diamond");
}

TEST(CheckSpec, Materials) {
  EXPECT_EQ(refusal([](NetSpec& s) { s.thread.young_modulus = 0.0; }),
            "net.thread.young_modulus = 0: must be greater than 0 (Pa)");
  EXPECT_EQ(refusal([](NetSpec& s) { s.thread.density = -1390.0; }),
            "net.thread.density = -1390: must be greater than 0 (kg/m3)");
  EXPECT_EQ(refusal([](NetSpec& s) { s.thread.radius = 0.0; }),
            "net.thread.radius = 0: must be greater than 0 (m)");
  EXPECT_EQ(refusal([](NetSpec& s) { s.thread.bending_stiffness = -1.0; }),
            "net.thread.bending_stiffness = -1: must be at least 0 (N m2)");
  EXPECT_EQ(refusal([](NetSpec& s) { s.thread.material_damping = -1.0; }),
            "net.thread.material_damping = -1: must be at least 0 (s)");
  EXPECT_EQ(refusal([](NetSpec& s) { s.thread.strength = 0.0; }),
            "net.thread.strength = 0: must be greater than 0 (N)");
  EXPECT_EQ(refusal([](NetSpec& s) { s.border.young_modulus = 0.0; }),
            "net.border.young_modulus = 0: must be greater than 0 (Pa)");
  EXPECT_EQ(refusal([](NetSpec& s) { s.border.density = 0.0; }),
            "net.border.density = 0: must be greater than 0 (kg/m3)");
  EXPECT_EQ(refusal([](NetSpec& s) { s.border.radius = -0.01; }),
            "net.border.radius = -0.01: must be greater than 0 (m)");
  EXPECT_EQ(refusal([](NetSpec& s) { s.border.bending_stiffness = -1.0; }),
            "net.border.bending_stiffness = -1: must be at least 0 (N m2)");
  EXPECT_EQ(refusal([](NetSpec& s) { s.border.strength = -1.0; }),
            "net.border.strength = -1: must be greater than 0 (N)");
}

TEST(CheckSpec, StartAndMasses) {
  EXPECT_EQ(refusal([](NetSpec& s) { s.scale = 0.0; }), "net.scale = 0: must be greater than 0");
  EXPECT_EQ(refusal([](NetSpec& s) { s.scale = 1.5, s.zigzag = true; }),
            "net.scale = 1.5: must be at most 1 with net.zigzag = true");
  EXPECT_EQ(refusal([](NetSpec& s) { s.disturbance = -1.0; }),
            "net.disturbance = -1: must be at least 0 (m)");
  EXPECT_EQ(refusal([](NetSpec& s) { s.position.x() = kInfinity; }),
            "net.position: must be finite (m)");
  EXPECT_EQ(refusal([](NetSpec& s) { s.knot_mass = -1.0; }),
            "net.knot_mass = -1: must be at least 0 (kg)");
  EXPECT_EQ(refusal([](NetSpec& s) { s.corner_mass.mass = -1.0; }),
            "net.corner_mass.mass = -1: must be at least 0 (kg)");
  EXPECT_EQ(refusal([](NetSpec& s) { s.corner_mass.bridle = -1.0; }),
            "net.corner_mass.bridle = -1: must be at least 0 (m)");
  EXPECT_EQ(refusal([](NetSpec& s) { s.corner_mass.bridle_segments = 0; }),
            "net.corner_mass.bridle_segments = 0: must be at least 1");
}

}  // namespace
}  // namespace retiarius
