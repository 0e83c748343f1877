#include "retiarius/base/build_info.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace retiarius {
namespace {

using ::testing::Contains;
using ::testing::ContainsRegex;
using ::testing::Each;
using ::testing::Key;
using ::testing::MatchesRegex;
using ::testing::Pair;

TEST(BuildInfo, NamesVersionCompilerAndBuildType) {
  const BuildInfo& info = build_info();
  EXPECT_THAT(info.version, MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+"));
  EXPECT_THAT(info.compiler, ContainsRegex("^[A-Za-z]+ [0-9]+"));
  EXPECT_FALSE(info.build_type.empty());
}

TEST(BuildInfo, ListsOptionsThatChangeResults) {
  EXPECT_THAT(build_info().options, Contains(Key("native")));
  EXPECT_THAT(build_info().options, Contains(Key("sanitize")));
  EXPECT_THAT(build_info().options, Contains(Key("flags")));
  EXPECT_THAT(build_info().kernels, MatchesRegex("portable|native"));
}

TEST(BuildInfo, EveryLibraryHasAVersion) {
  EXPECT_GE(build_info().libraries.size(), 10u);
  EXPECT_THAT(build_info().libraries,
              Each(Pair(MatchesRegex("[A-Za-z0-9+-]+"), MatchesRegex("[0-9][0-9A-Za-z.~-]*"))));
}

}  // namespace
}  // namespace retiarius
