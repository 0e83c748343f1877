#include "retiarius/mission/writer.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "retiarius/mission/schema.hpp"
#include "retiarius/mission/trigger.hpp"
#include "texts.hpp"

namespace retiarius {
namespace {

using testing::HasSubstr;

template <class Spec>
void expect_same(const Table<Spec>& table, const Spec& a, const Spec& b) {
  EXPECT_EQ(table.values(a), table.values(b)) << table.info.path;
}

template <class Spec>
void expect_same_settings(const Spec& a, const Spec& b) {
  expect_same(environment_table(), a.environment, b.environment);
  expect_same(integrator_table(), a.integrator, b.integrator);
  expect_same(contact_table(), a.contact, b.contact);
}

// Bit for bit, over every key that belongs.
void expect_same(const Mission& a, const Mission& b) {
  expect_same(mission_table(), a, b);
  expect_same(net_table(), a.net, b.net);
  expect_same(thread_table(), a.net.thread, b.net.thread);
  expect_same(border_table(), a.net.border, b.net.border);
  expect_same(corner_mass_table(), a.net.corner_mass, b.net.corner_mass);
  expect_same_settings(a, b);
  expect_same(output_table(), a.output, b.output);
  ASSERT_EQ(a.targets.size(), b.targets.size());
  for (std::size_t i = 0; i < a.targets.size(); ++i) {
    expect_same(target_table(), a.targets[i], b.targets[i]);
  }
  ASSERT_EQ(a.phases.size(), b.phases.size());
  for (std::size_t i = 0; i < a.phases.size(); ++i) {
    expect_same(phase_table(), a.phases[i], b.phases[i]);
    expect_same_settings(a.phases[i], b.phases[i]);
    ASSERT_EQ(a.phases[i].move.size(), b.phases[i].move.size());
    for (std::size_t j = 0; j < a.phases[i].move.size(); ++j) {
      expect_same(move_table(), a.phases[i].move[j], b.phases[i].move[j]);
    }
  }
  ASSERT_EQ(a.probes.size(), b.probes.size());
  for (std::size_t i = 0; i < a.probes.size(); ++i) {
    expect_same(probe_table(), a.probes[i], b.probes[i]);
  }
}

TEST(Writer, ResolvedMissionsReadBackTheSame) {
  const std::vector<std::string> overrides[] = {
      {},
      {"net.thread.radius=0.1", "net.thread.density=1e300", "net.disturbance=5e-324"},
      {"net.thread.young_modulus=7.0000000000000001e10", "integrator.step=0.0033333333333333335",
       "output.interval=0.0033333333333333335", "output.frame_interval=0.013333333333333334"},
      {"title=\"quotes \\\" and \\\\ and \\n and \\u0001 and é\"", "seed=9223372036854775807"},
      {"target.shape=sphere", "target.radius=2", "target.mass=3", "phase[0].fix=[\"corner0\", 4]",
       "target.inertia=[1,2,3]"},
      {"phase[0].move=[{nodes=\"center\",velocity=[1,2,3]},{nodes=[1,2],displacement=[0,0,1],"
       "duration=2}]"},
      {"phase[0].kind=shoot", "phase[0].speed=[1,2,3,4,5,6]", "phase[0].axis=[0,1,0]"},
      {"phase[0].integrator.method=static", "phase[0].integrator.step=0.3",
       "environment.gravity=[0,0,-9.81]"},
      {"phase[0].kind=fold", "phase[0].grips=spokes", "phase[0].grip_spacing=1",
       "phase[0].duration=1", "phase[0].name=\"stow it\"", "probe[0].node=center"},
      {"target.shape=plane", "target.motion=fixed", "phase[0].kind=close", "phase[0].delay=1"}};
  for (const auto& set : overrides) {
    const Mission mission = parse_mission(kLeast, "m.toml", "/", set);
    const std::string text = to_toml(mission);
    const Mission again = parse_mission(text, "again.toml", "/tmp");
    expect_same(mission, again);
    EXPECT_EQ(to_toml(again), text);
  }
}

TEST(Writer, ShowsDefaultsUnitsAndAbsentValues) {
  const std::string text = to_toml(parse_mission(kLeast));
  EXPECT_THAT(text, testing::StartsWith("format = 1\n"));
  EXPECT_THAT(text, HasSubstr("[net.thread]\nyoung_modulus = 1000000.0  # Pa\n"));
  EXPECT_THAT(text, HasSubstr("# bending_stiffness: solid rod, E pi r0^4 / 4\n"));
  EXPECT_THAT(text, HasSubstr("gravity = [0.0, 0.0, 0.0]  # m/s2\n"));
  EXPECT_THAT(text, HasSubstr("tolerance = 1e-08\n"));
  EXPECT_THAT(text, HasSubstr("fix = \"none\"\n"));
  EXPECT_THAT(text, HasSubstr("[phase.integrator]\nmethod = \"implicit-euler\"\n"));
}

TEST(Writer, KeepsAnUnendingMove) {
  const Mission mission =
      parse_mission(kLeast, "m.toml", ".", {"phase[0].move=[{nodes=\"center\",velocity=[1,0,0]}]"});
  EXPECT_EQ(mission.phases[0].move[0].duration, kInfinity);
  EXPECT_THAT(to_toml(mission), HasSubstr("duration = inf  # s\n"));
}

TEST(Writer, PathsBecomeAbsolute) {
  const std::string source = RETIARIUS_SOURCE_DIR;
  const Mission mission =
      parse_mission(kLeast, "m.toml", source + "/tests/mission", {"net.state=../CMakeLists.txt"});
  EXPECT_EQ(mission.net.state, "../CMakeLists.txt");
  EXPECT_THAT(to_toml(mission),
              HasSubstr(fmt::format("state = \"{}/tests/CMakeLists.txt\"\n", source)));
}

TEST(Document, NamesEveryKeyOfEveryTable) {
  const std::string text = mission_file_markdown();
  for (const TableView& table : schema_tables()) {
    const std::string heading =
        table.info->path.empty() ? "## Top of the file" : fmt::format("[{}]", table.info->path);
    const auto at = text.find(heading);
    ASSERT_NE(at, std::string::npos) << heading;
    const std::string section = text.substr(at, text.find("\n## ", at) - at);
    for (const KeyInfo* k : table.keys) {
      EXPECT_THAT(section, HasSubstr(fmt::format("| `{}` | ", k->name)));
      EXPECT_THAT(section, HasSubstr(k->meaning));
      for (const auto& word : k->words) EXPECT_THAT(section, HasSubstr("`\"" + word + "\"`"));
    }
  }
  for (const TriggerName& name : trigger_names()) {
    EXPECT_THAT(text, HasSubstr(fmt::format("| `{}` | ", name.name)));
  }
}

TEST(Document, PageIsUpToDate) {
  const std::string path = std::string(RETIARIUS_SOURCE_DIR) + "/docs/mission-file.md";
  if (std::getenv("RETIARIUS_UPDATE_DOCS") != nullptr) {
    std::filesystem::create_directories(std::filesystem::path(path).parent_path());
    std::ofstream(path) << mission_file_markdown();
  }
  std::ostringstream page;
  page << std::ifstream(path).rdbuf();
  EXPECT_EQ(page.str(), mission_file_markdown())
      << "docs/mission-file.md differs from the schema; write it anew with\n"
         "  RETIARIUS_UPDATE_DOCS=1 test_mission --gtest_filter=Document.PageIsUpToDate";
}

TEST(Starter, ReadsWithoutWarnings) {
  const std::string text = starter_mission("My \"first\" net");
  const Mission mission = parse_mission(text, "starter.toml");
  EXPECT_EQ(mission.title, "My \"first\" net");
  EXPECT_EQ(mission.phases.size(), 3u);
  EXPECT_EQ(mission.targets.size(), 1u);
  EXPECT_EQ(mission.contact.method, ContactMethod::modified_mass);
  EXPECT_THAT(mission_warnings(mission), testing::IsEmpty());
}

}  // namespace
}  // namespace retiarius
