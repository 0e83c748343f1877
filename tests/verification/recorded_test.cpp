#include "verification/framework/recorded.hpp"

#include <gmock/gmock.h>

#include "retiarius/base/error.hpp"

namespace retiarius::verification {
namespace {

TEST(ParseRecorded, ReadsParagraphsScenesAndValues) {
  const Recorded r =
      parse_recorded("# First.\n# Second.\nscene,net,1.5,2.5\nvalue,net,sag,m,0.5,0.4,0.1,0.2\n");
  EXPECT_THAT(r.about, ::testing::ElementsAre("First.", "Second."));
  ASSERT_EQ(r.scenes.size(), 1u);
  EXPECT_EQ(r.scenes[0].their_time, 2.5);
  ASSERT_EQ(r.comparisons.size(), 1u);
  EXPECT_EQ(r.comparisons[0].quantity, "sag");
  EXPECT_EQ(r.comparisons[0].theirs, 0.4);
  EXPECT_EQ(r.comparisons[0].bound, 0.2);
}

std::string failure(const std::string& csv) {
  try {
    parse_recorded(csv);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(ParseRecorded, LeavesAbsentNumbersOut) {
  const Recorded r = parse_recorded("value,net,distance,m,-,-,0.1,0.2\n");
  EXPECT_EQ(recorded_text(r.comparisons[0].ours, 3, "m"), "\u2013");
  EXPECT_EQ(recorded_text(r.comparisons[0].difference, 3, "m"), "0.100 m");
}

// What is built in is there to be read.
TEST(RecordedComparisons, AreWithinTheirBounds) {
  const Recorded r = recorded_comparisons();
  EXPECT_FALSE(r.about.empty());
  ASSERT_FALSE(r.comparisons.empty());
  for (const RecordedComparison& c : r.comparisons) EXPECT_LE(c.difference, c.bound) << c.quantity;
}

TEST(ParseRecorded, NamesALineThatIsWrong) {
  EXPECT_EQ(failure("scene,net,1.5\n"),
            "recorded comparisons: a line of neither kind: \"scene,net,1.5\"");
  EXPECT_EQ(failure("scene,net,fast,2\n"),
            "recorded comparisons: \"fast\" is no number in \"scene,net,fast,2\"");
}

}  // namespace
}  // namespace retiarius::verification
