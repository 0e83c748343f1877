#include "retiarius/mission/reader.hpp"

#include <gmock/gmock.h>

#include "texts.hpp"

namespace retiarius {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

const std::string kFull = R"(format = 1
title = "Everything"
seed = 7

[net]
pattern = "hexagon"
side = 1.0
mesh = 0.2
segments = 4
knots = "hinged"
knot_mass = 0.01
scale = 0.5
zigzag = true
disturbance = 1e-9
position = [0, 0, 1]

[net.thread]
young_modulus = 1.0e6
density = 1000
radius = 0.01
bending = "bounded"
bending_stiffness = 1e-6
compression = false
material_damping = 1e-4
strength = 500

[net.border]
radius = 0.02

[net.corner_mass]
mass = 0.5
bridle = 0.3
bridle_segments = 3

[[target]]
shape = "box"
size = [1, 2, 3]
mass = 100
spin_deg = [0, 0, 5]

[[target]]
shape = "plane"
motion = "fixed"
position = [0, 0, -10]

[environment]
gravity = [0.0, 0.0, -50.0]
damping = 0.1

[integrator]
method = "newmark"
step = 0.005
tolerance = 1e-10

[contact]
method = "modified-mass"
friction = 0.3
self = false

[[phase]]
kind = "fold"
grips = "spokes"
grip_spacing = 0.4
duration = 3
until = "phase_time >= 3"
[phase.environment]
gravity = [0, 0, -9.81]
[[phase.move]]
nodes = ["center", 3]
displacement = [0, 0, 1]
duration = 2

[[phase]]
kind = "shoot"
speed = [1, 2, 3, 4, 5, 6]
half_angle_deg = 30
axis = [1, 0, 0]
until = "distance >= 3 or contact"
[phase.integrator]
step = 0.001

[[phase]]
name = "wrap"
kind = "close"
path = "straight"
distance = 0.5
radius = 0.1
speed = 2.5
delay = 0.2
fix = "none"
until = "time >= 9"
[phase.contact]
friction = 0.9

[[probe]]
name = "middle"
node = "center"

[[probe]]
node = 12

[output]
interval = 0.01
frame_interval = 0.1
)";

TEST(Reader, LeastMissionHasTheDefaults) {
  const Mission m = parse_mission(kLeast);
  EXPECT_EQ(m.net.pattern, Pattern::hexagon);
  EXPECT_EQ(m.net.segments, 1);
  EXPECT_EQ(m.net.knots, Knots::continuous);
  EXPECT_EQ(m.net.scale, 1.0);
  EXPECT_EQ(m.net.thread.bending, Bending::none);
  EXPECT_TRUE(m.net.thread.compression);
  EXPECT_FALSE(m.net.thread.bending_stiffness.has_value());
  EXPECT_EQ(m.net.corner_mass.mass, 0.0);
  EXPECT_THAT(m.targets, IsEmpty());
  EXPECT_EQ(m.environment.gravity, Vec3::Zero());
  EXPECT_EQ(m.environment.damping, 0.0);
  EXPECT_EQ(m.integrator.method, Method::implicit_euler);
  EXPECT_EQ(m.integrator.tolerance, 1e-8);
  EXPECT_EQ(m.contact.method, ContactMethod::none);
  EXPECT_EQ(m.contact.friction, 0.0);
  ASSERT_EQ(m.phases.size(), 1u);
  EXPECT_EQ(m.phases[0].name, "free");
  EXPECT_THAT(m.phases[0].fix, IsEmpty());
  EXPECT_EQ(m.output.interval, 0.01);
}

TEST(Reader, FullMissionFillsEveryTable) {
  const Mission m = parse_mission(kFull);
  EXPECT_EQ(m.title, "Everything");
  EXPECT_EQ(m.seed, 7u);
  EXPECT_EQ(m.net.knots, Knots::hinged);
  EXPECT_EQ(m.net.position, Vec3(0, 0, 1));
  EXPECT_EQ(m.net.thread.bending_stiffness, 1e-6);
  EXPECT_EQ(m.net.thread.density, 1000.0);
  EXPECT_EQ(m.net.border.radius, 0.02);
  EXPECT_EQ(m.net.corner_mass.bridle_segments, 3);
  ASSERT_EQ(m.targets.size(), 2u);
  EXPECT_EQ(m.targets[0].name, "target");
  EXPECT_EQ(m.targets[0].size, Vec3(1, 2, 3));
  EXPECT_EQ(m.targets[1].name, "target1");
  EXPECT_EQ(m.targets[1].motion, BodyMotion::fixed);
  EXPECT_EQ(m.contact.method, ContactMethod::modified_mass);
  ASSERT_EQ(m.probes.size(), 2u);
  EXPECT_EQ(m.probes[0].name, "middle");
  EXPECT_EQ(m.probes[1].name, "12");
  EXPECT_EQ(m.output.frame_interval, 0.1);
}

TEST(Reader, PhasesInheritAndOverride) {
  const Mission m = parse_mission(kFull);
  ASSERT_EQ(m.phases.size(), 3u);
  const PhaseSpec &fold = m.phases[0], &shoot = m.phases[1], &close = m.phases[2];
  EXPECT_EQ(fold.environment.gravity, Vec3(0, 0, -9.81));
  EXPECT_EQ(fold.environment.damping, 0.1);
  EXPECT_EQ(shoot.environment.gravity, Vec3(0, 0, -50));
  EXPECT_EQ(shoot.integrator.step, 0.001);
  EXPECT_EQ(shoot.integrator.method, Method::newmark);
  EXPECT_EQ(close.contact.friction, 0.9);
  EXPECT_EQ(close.contact.method, ContactMethod::modified_mass);
  EXPECT_EQ(m.contact.friction, 0.3);
}

TEST(Reader, PhasesKeepTheirOwnKeys) {
  const Mission m = parse_mission(kFull);
  const PhaseSpec &fold = m.phases[0], &shoot = m.phases[1], &close = m.phases[2];
  EXPECT_THAT(fold.grips, ElementsAre("spokes"));
  ASSERT_EQ(fold.move.size(), 1u);
  EXPECT_THAT(fold.move[0].nodes, ElementsAre("center", "3"));
  EXPECT_THAT(shoot.speed, ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_THAT(shoot.half_angle_deg, ElementsAre(30.0));
  EXPECT_THAT(shoot.delay, ElementsAre(0.0));
  EXPECT_EQ(shoot.axis, Vec3::UnitX());
  EXPECT_EQ(close.name, "wrap");
  EXPECT_EQ(close.close_speed, 2.5);
  EXPECT_THAT(close.delay, ElementsAre(0.2));
  EXPECT_THAT(close.fix, IsEmpty());
  EXPECT_EQ(close.path, ClosePath::straight);
  EXPECT_EQ(close.place.line, 82);
}

}  // namespace
}  // namespace retiarius
