#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "program/verification_results.hpp"
#include "tests/program/subprocess.hpp"
#include "tests/verification/made_results.hpp"

namespace retiarius {
namespace {

using ::testing::HasSubstr;
using testing::ProcessResult;
using testing::WorkFolder;

TEST(VerifyCommand, ListsCasesWithoutRunningThem) {
  const WorkFolder folder;
  const ProcessResult result = folder.run({"verify", "--list"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.out, HasSubstr("hexagon-gravity"));
  EXPECT_EQ(folder.listing(), "");
}

TEST(VerifyCommand, RefusesAnUnknownCaseAndNamesTheNearest) {
  const WorkFolder folder;
  const ProcessResult result = folder.run({"verify", "hexagon-gravitie"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("there is no verification case hexagon-gravitie"));
  EXPECT_THAT(result.err, HasSubstr("hexagon-gravity"));
  EXPECT_EQ(folder.listing(), "");
}

TEST(VerifyCommand, RunsACaseAndLeavesPageDocumentAndFigures) {
  const WorkFolder folder;
  const ProcessResult result = folder.run({"verify", "hexagon-gravity", "--quick", "--out", "v"});
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_THAT(result.out, HasSubstr("1 of 1 cases passed"));
  EXPECT_THAT(result.out, HasSubstr("report: v/verification.html"));
  for (const char* file : {"v/verification.html", "v/verification.json", "v/verification.md",
                           "v/figures/hexagon-gravity-1.svg"})
    EXPECT_TRUE(folder.has(file)) << file;
  EXPECT_THAT(folder.read("v/verification.html"), HasSubstr("All within bounds"));
  EXPECT_EQ(nlohmann::json::parse(folder.read("v/verification.json"))["passes"], true);
}

TEST(Conclude, FailsWhereABoundIsMissedAndStillWritesAll) {
  const WorkFolder folder;
  const auto out = folder / "v";
  EXPECT_EQ(program::conclude(verification::testing::made_rungs(), out, true, 1.0),
            program::kFailed);
  EXPECT_THAT(folder.read("v/verification.html"), HasSubstr("Not all within bounds"));
  EXPECT_TRUE(folder.has("v/figures/elastica-1.svg"));
  EXPECT_EQ(program::conclude(verification::testing::good_rungs(), out, true, 1.0), program::kOk);
  EXPECT_THAT(folder.read("v/verification.html"), HasSubstr("All within bounds"));
}

}  // namespace
}  // namespace retiarius
