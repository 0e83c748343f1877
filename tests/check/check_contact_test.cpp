#include "retiarius/check/check_contact.hpp"

#include <cmath>
#include <fstream>

#include <gmock/gmock.h>

#include "retiarius/base/error.hpp"
#include "retiarius/check/check_json.hpp"
#include "tests/check/planted_run.hpp"

namespace retiarius {
namespace {

using ::testing::HasSubstr;
using testing::mission_with;
using testing::PlantedRun;

// 1 mm thick, across the middle of the net; its top face is at z = 0.5 mm.
const char* const kPanel = "shape = \"box\"\nsize = [0.3, 0.2, 0.001]\n";

TEST(CheckContact, PassesANetThatStaysClear) {
  PlantedRun run(mission_with(kPanel));
  for (int k = 0; k <= 4; ++k) {
    run.lift(0.1 - 0.02 * k);
    run.save(0.01 * k);
  }
  run.lift(0.5e-3 + 1.001e-3);  // just above the radius
  run.save(0.05);
  const ContactCheck check = run.check();
  EXPECT_TRUE(check.clean());
  EXPECT_EQ(check.states, 6u);
  EXPECT_EQ(check.motions, 5u);
  EXPECT_GT(check.looked_at, 8u);  // it did look: the middle threads at every state
  EXPECT_TRUE(check.worst.empty());
  EXPECT_EQ(check.bodies, std::vector<std::string>{"target"});
}

TEST(CheckContact, TellsThePlantedDepthOfAState) {
  constexpr double kDepth = 3e-4;
  PlantedRun run(mission_with(kPanel));
  run.lift(0.1);
  run.save(0.0);
  run.lift(0.5e-3 + 1e-3 - kDepth);
  run.save(0.25);
  const ContactCheck check = run.check();
  EXPECT_EQ(check.penetrations, 4u);  // the four segments at the centre
  EXPECT_EQ(check.approaches, 0u);    // 0.7 of the radius is left: more than the share
  EXPECT_EQ(check.crossings, 0u);
  ASSERT_EQ(check.worst.size(), 1u);
  EXPECT_EQ(check.worst[0].fault, ContactFault::penetration);
  EXPECT_NEAR(check.worst[0].depth, kDepth, 1e-12);
  EXPECT_NEAR(check.deepest, kDepth, 1e-12);
  EXPECT_EQ(check.worst[0].time, 0.25);
  EXPECT_EQ(check.worst[0].body, 0);
}

TEST(CheckContact, SeesAnApproachBetweenStates) {
  PlantedRun run(mission_with("shape = \"sphere\"\nradius = 0.1\n"));
  // The net passes over the sphere sideways, clear of it at both states.
  run.x = run.network().design;
  for (Vec3& p : run.x) p += Vec3(0.8, 0.8, 0.1 + 0.3e-3);
  run.save(0.0);
  for (Vec3& p : run.x) p -= Vec3(1.6, 1.6, 0.0);
  run.save(1.0);
  const ContactCheck check = run.check();
  EXPECT_EQ(check.penetrations, 0u);
  EXPECT_GT(check.approaches, 0u);
  EXPECT_EQ(check.crossings, 0u);
  ASSERT_FALSE(check.worst.empty());
  EXPECT_NEAR(check.worst[0].distance, 0.3e-3, 0.02e-3);
  EXPECT_NEAR(check.worst[0].depth, 0.7e-3, 0.02e-3);
  EXPECT_GT(check.worst[0].time, 0.0);
  EXPECT_LT(check.worst[0].time, 1.0);
}

TEST(CheckContact, SeesTunnellingThroughAThinPanel) {
  PlantedRun run(mission_with(kPanel));
  run.lift(0.1);  // 20 m/s for 10 ms
  run.save(0.0);
  run.lift(-0.1);
  run.save(0.01);
  const ContactCheck check = run.check();
  EXPECT_EQ(check.penetrations, 0u);
  EXPECT_EQ(check.crossings, 4u);
  ASSERT_EQ(check.worst.size(), 1u);
  EXPECT_EQ(check.worst[0].fault, ContactFault::crossing);
  EXPECT_NEAR(check.worst[0].time, 0.005, 1e-5);
  EXPECT_NEAR(check.worst[0].depth, 1.5e-3, 0.05e-3);
}

// A flat tetrahedron, 0.4 mm high, as a mesh.
TEST(CheckContact, SeesTunnellingThroughAMesh) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() /
                                     ("retiarius-rod-" + std::to_string(getpid()) + ".obj");
  std::ofstream(file) << "v -0.25 0.2 -0.0002\nv -0.15 0.2 -0.0002\nv -0.25 0.3 -0.0002\n"
                         "v -0.2 0.25 0.0002\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  {
    PlantedRun run(mission_with("shape = \"mesh\"\nfile = \"" + file.string() + "\"\n"));
    run.lift(0.05);
    run.save(0.0);
    std::filesystem::remove(file);  // the check goes by what the run recorded
    run.lift(-0.05);
    run.save(0.01);
    const ContactCheck check = run.check();
    EXPECT_EQ(check.penetrations, 0u);
    EXPECT_GT(check.crossings, 0u);
  }
  std::filesystem::remove(file);
}

// The net rests; a bar turns through its threads, or below them.
TEST(CheckContact, SeesATurningBodyPass) {
  for (const double z : {0.0, 0.012}) {
    PlantedRun run(mission_with("shape = \"box\"\nsize = [0.6, 0.02, 0.02]\n"));
    // Threads along x at y = 0.25 and along y at x = 0.25, which the bar's ends pass between
    // states.
    for (Vec3& p : run.x) p += Vec3(0.25, 0.25, z);
    for (const double angle : {-0.7, -2.4}) {
      run.poses[0].attitude = Quat(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
      run.save(angle);
    }
    const ContactCheck check = run.check();
    EXPECT_EQ(check.penetrations, 0u);
    EXPECT_EQ(check.crossings > 0, z == 0.0);
    EXPECT_EQ(check.clean(), z > 0.0);
  }
}

// The first row of the net lies across the last one, at height z.
void row_over_row(PlantedRun& run, double z) {
  run.x = run.network().design;
  for (Vec3& p : run.x) {
    if (p.y() < -0.1) p = Vec3(p.x(), 0.4 + 0.3 * p.x(), z);
  }
}

// Threads of the first row swing down through a thread of the last one.
TEST(CheckContact, SeesThreadsPassThroughEachOther) {
  for (const double to : {-0.05, 0.02}) {
    PlantedRun run(mission_with("shape = \"sphere\"\nradius = 0.1\nposition = [0, 0, 9]\n"));
    row_over_row(run, 0.05);
    run.save(0.0);
    row_over_row(run, to);
    run.save(1.0);
    ContactCheckOptions self;
    self.self = true;
    const ContactCheck check = run.check(self);
    EXPECT_TRUE(check.self);
    EXPECT_EQ(check.penetrations, 0u);
    EXPECT_EQ(check.crossings > 0, to < 0.0);
    if (to > 0.0) {
      EXPECT_EQ(check.approaches, 0u);
    } else {
      ASSERT_FALSE(check.worst.empty());
      EXPECT_EQ(check.worst[0].body, kNone);
      EXPECT_NEAR(check.worst[0].time, 0.5, 1e-3);
      EXPECT_NEAR(check.worst[0].depth, 2e-3, 0.05e-3);
    }
  }
}

TEST(CheckContact, ChecksThreadsOnThreadsWhereTheMissionSaysSo) {
  const std::string mission =
      mission_with("shape = \"sphere\"\nradius = 0.1\nposition = [0, 0, 9]\n");
  const auto check = [&](const std::string& recorded) {
    PlantedRun run(mission, recorded);
    row_over_row(run, 1.5e-3);  // 2 mm is the sum of radii
    run.save(0.0);
    return run.check();
  };
  const ContactCheck silent = check(mission);
  EXPECT_FALSE(silent.self);
  EXPECT_TRUE(silent.clean());
  for (const std::string& recorded :
       {mission + "[contact]\nself = true\n",
        testing::replaced_once(mission, "kind = \"free\"",
                               "kind = \"free\"\ncontact.self = true")}) {
    const ContactCheck found = check(recorded);
    EXPECT_TRUE(found.self);
    EXPECT_GT(found.penetrations, 0u);
    // Lowest is the thread that comes down from (0.5, 0.55, 1.5 mm) to the middle row, where it
    // passes over the last row.
    const double height = 1.5e-3 * 0.5 / 0.55 * std::cos(std::atan(1.5e-3 / 0.55));
    EXPECT_NEAR(found.deepest, 2e-3 - height, 1e-12);
  }
}

TEST(CheckContact, RefusesAFolderWithoutRun) {
  EXPECT_THROW(check_contact("/nonexistent"), InputError);
  ContactCheckOptions options;
  options.share = 0.0;
  EXPECT_THROW(check_contact("/nonexistent", options), InputError);
}

TEST(CheckContact, IsWrittenAsJson) {
  PlantedRun run(mission_with(kPanel));
  run.lift(1e-3);
  run.save(0.0);
  const std::string text = contact_check_json(run.check());
  EXPECT_THAT(text, HasSubstr("\"clean\": false"));
  EXPECT_THAT(text, HasSubstr("\"fault\": \"penetration\""));
  EXPECT_THAT(text, HasSubstr("\"body\": \"target\""));
}

}  // namespace
}  // namespace retiarius
