// Wrong arguments, help and version.
#include <gmock/gmock.h>

#include "retiarius/base/build_info.hpp"
#include "retiarius/base/instruction_set.hpp"
#include "tests/program/subprocess.hpp"

namespace retiarius {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing::ProcessResult;
using ::testing::StartsWith;
using testing::WorkFolder;

void expect_usage_error(const std::vector<std::string>& arguments, const std::string& text) {
  const WorkFolder folder;
  const ProcessResult result = folder.run(arguments);
  EXPECT_EQ(result.exit_code, 2) << result.err;
  EXPECT_THAT(result.err, StartsWith("retiarius: error: "));
  EXPECT_THAT(result.err, HasSubstr(text));
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(folder.listing(), "");
}

TEST(Usage, WrongArgumentsAreNamedWithARemedy) {
  expect_usage_error({}, "no command given; allowed: run, resume, validate, new, info, export");
  expect_usage_error({"rnu"}, "there is no command rnu, did you mean run?");
  expect_usage_error({"--fast"}, "see `retiarius --help`");
  expect_usage_error({"run"}, "MISSION is required; see `retiarius run --help`");
  expect_usage_error({"run", "m.toml", "--color"}, "--color");
  expect_usage_error({"run", "m.toml", "--threads", "0"}, "--threads");
  expect_usage_error({"run", "m.toml", "--threads", "many"}, "many");
  expect_usage_error({"run", "m.toml", "--kernels", "fast"}, "fast");
  expect_usage_error({"export", "run"}, "--to is required");
  expect_usage_error({"export", "run", "--to", "xls"}, "xls");
  expect_usage_error({"docs", "poems"}, "poems");
}

TEST(Usage, HelpListsTheCommandsThatUsersNeed) {
  const ProcessResult result = WorkFolder().run({"--help"});
  EXPECT_EQ(result.exit_code, 0);
  for (const char* name : {"run", "validate", "new", "info", "export", "--version"})
    EXPECT_THAT(result.out, HasSubstr(name));
  EXPECT_THAT(result.out, Not(HasSubstr("docs")));
  EXPECT_EQ(result.err, "");
}

TEST(Usage, HelpOfRunTellsOptionsAndExitCodes) {
  const ProcessResult result = WorkFolder().run({"run", "--help"});
  EXPECT_EQ(result.exit_code, 0);
  for (const char* name : {"--out", "--set", "--threads", "--kernels", "--quiet", "--start",
                           "Exit codes", "PATH=VALUE"})
    EXPECT_THAT(result.out, HasSubstr(name));
}

TEST(Usage, VersionTellsHowTheProgramWasBuilt) {
  const ProcessResult result = WorkFolder().run({"--version"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.out, StartsWith("retiarius " + build_info().version + "\n"));
  EXPECT_THAT(result.out, HasSubstr(build_info().compiler));
  EXPECT_THAT(result.out, HasSubstr(build_info().build_type));
  EXPECT_THAT(result.out, HasSubstr("option native"));
  EXPECT_THAT(result.out, HasSubstr("revision"));
  for (const auto name : available_kernels()) EXPECT_THAT(result.out, HasSubstr(std::string(name)));
}

}  // namespace
}  // namespace retiarius
