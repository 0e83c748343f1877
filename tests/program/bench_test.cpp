// retiarius bench: what is timed, and how it is told.
#include <gmock/gmock.h>

#include "tests/program/subprocess.hpp"

namespace retiarius {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using testing::ProcessResult;
using testing::small_mission;

using testing::WorkFolder;

TEST(Bench, FliesInEveryWay) {
  const WorkFolder folder;
  const ProcessResult result = folder.run(
      {"bench", "flights", "--quick", "--segments", "2", "--threads", "1", "--csv", "f.csv"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  for (const char* way : {"explicit +explicit", "auto +explicit", "plain-explicit +plain explicit",
                          "implicit-euler +implicit-euler"})
    EXPECT_THAT(result.out, ContainsRegex(std::string(" 2 +1976 +") + way + " +[0-9]"));
  EXPECT_THAT(folder.read("f.csv"), HasSubstr("\n2,1976,plain-explicit,"));
}

TEST(Bench, TimesTheNetsAskedFor) {
  const WorkFolder folder;
  const ProcessResult result =
      folder.run({"bench", "--edges", "2,3", "--quick", "--threads", "1", "--csv", "n.csv"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, ContainsRegex("\n +37 +3 +0 +across +0.01 +1 +auto "));
  EXPECT_THAT(folder.read("n.csv"), HasSubstr("\n343,2,9,0,"));
  EXPECT_EQ(folder.run({"bench", "--edges", "1"}).exit_code, 2);
}

TEST(Bench, TimesThreads) {
  const WorkFolder folder;
  const ProcessResult result = folder.run({"bench", "threads", "--largest", "9000", "--steps", "1",
                                           "--repeats", "1", "--csv", "t.csv"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, ContainsRegex("\n7981 nodes: two threads at [0-9]+ % efficiency\n"));
  EXPECT_THAT(folder.read("t.csv"), ContainsRegex("\n7981,19,3,1,1,0.01,2,auto,1,"));
}

TEST(Bench, TimesAMission) {
  const WorkFolder folder;
  folder.write("m.toml", small_mission());
  const ProcessResult result = folder.run({"bench", "mission", "--mission", "m.toml", "--set",
                                           "integrator.solver=direct", "--csv", "m.csv"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, ContainsRegex("\nm +integrator.solver=direct +finished +[0-9]+ +0.2 "));
  EXPECT_THAT(folder.read("m.csv"), HasSubstr("\nm,integrator.solver=direct,finished,"));
  EXPECT_FALSE(folder.has("out"));
}

TEST(Bench, SaysWhatItLacks) {
  const WorkFolder folder;
  ProcessResult result = folder.run({"bench", "mission"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("bench mission needs --mission FILE"));
  result = folder.run({"bench", "flights", "--json"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("told as a table or by --csv"));
  EXPECT_EQ(folder.run({"bench", "speed"}).exit_code, 2);
}

}  // namespace
}  // namespace retiarius
