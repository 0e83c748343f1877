#include "retiarius/base/error.hpp"

#include <gtest/gtest.h>

namespace retiarius {
namespace {

TEST(InputError, PutsThePlaceBeforeTheMessage) {
  const InputError error({"net.toml", 3, 7}, "radius is -1");
  EXPECT_STREQ(error.what(), "net.toml:3:7: radius is -1");
  EXPECT_EQ(error.place().line, 3);
}

TEST(InputError, LeavesOutWhatIsUnknown) {
  EXPECT_STREQ(InputError({"net.toml", 0, 0}, "is empty").what(), "net.toml: is empty");
  EXPECT_STREQ(InputError({"", 2, 0}, "x").what(), "2: x");
  EXPECT_STREQ(InputError(SourcePlace{}, "x").what(), "x");
}

}  // namespace
}  // namespace retiarius
