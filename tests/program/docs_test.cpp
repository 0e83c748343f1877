#include <gtest/gtest.h>

#include "retiarius/mission/writer.hpp"
#include "tests/program/subprocess.hpp"

namespace retiarius {
namespace {

TEST(Docs, PrintsThePageOfTheMissionFile) {
  const auto result = testing::WorkFolder().run({"docs", "mission-file"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, mission_file_markdown());
}

}  // namespace
}  // namespace retiarius
