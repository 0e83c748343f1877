// The same mission and binary give the same results bit for bit.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/program/subprocess.hpp"

namespace retiarius {
namespace {

using testing::small_mission;
using testing::WorkFolder;

// A net that falls on a tumbling box, with everything that computes in parallel.
std::string busy_mission() {
  return testing::replaced(small_mission(), "gravity = [0.0, 0.0, -50.0]",
                           "gravity = [0.0, 0.0, -50.0]\ndamping = 0.1") +
         R"(
[target]
shape = "box"
size = [0.8, 0.6, 0.4]
mass = 20.0
position = [0.0, 0.0, -0.3]
spin_deg = [20.0, 40.0, 10.0]

[contact]
method = "modified-mass"
friction = 0.3
)";
}

// history.csv and the checkpoint of a run with these arguments.
std::string results(const std::vector<std::string>& more) {
  const WorkFolder folder;
  std::vector<std::string> arguments{"run", folder.write("m.toml", busy_mission()), "--set",
                                     "phase[0].fix=none"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const auto result = folder.run(arguments);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(testing::line_count(folder.read("out/m/history.csv")), 12u);
  return folder.read("out/m/history.csv") + folder.read("out/m/checkpoint");
}

TEST(Determinism, SameRunTwice) { EXPECT_EQ(results({}), results({})); }

TEST(Determinism, NumberOfThreadsDoesNotMatter) {
  const std::vector<std::string> fine{"--set", "net.mesh=0.1"};
  const auto with_threads = [&](const char* count) {
    std::vector<std::string> arguments = fine;
    arguments.insert(arguments.end(), {"--threads", count});
    return results(arguments);
  };
  const std::string one = with_threads("1");
  EXPECT_EQ(with_threads("2"), one);
  EXPECT_EQ(with_threads("4"), one);
}

TEST(Determinism, PortableKernelsRunAndAreRecorded) {
  const WorkFolder folder;
  folder.write("m.toml", small_mission());
  const auto result = folder.run({"run", "m.toml", "--kernels", "portable"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(nlohmann::json::parse(folder.read("out/m/summary.json"))["kernels"], "portable");
  EXPECT_EQ(results({"--kernels", "portable"}), results({"--kernels", "portable"}));
}

}  // namespace
}  // namespace retiarius
