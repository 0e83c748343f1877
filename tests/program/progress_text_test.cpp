#include "program/progress_text.hpp"

#include <gtest/gtest.h>

#include "retiarius/mission/reader.hpp"
#include "tests/program/subprocess.hpp"

namespace retiarius::program {
namespace {

ProgressValues half_way() {
  ProgressValues values;
  values.phase = "close";
  values.number = 4;
  values.count = 5;
  values.time = 1.5;
  return values;
}

TEST(ProgressText, ShowsBarSpeedAndTimeLeft) {
  ProgressValues values = half_way();
  values.end = 3.0;
  values.speed = 0.25;
  EXPECT_EQ(progress_text(values),
            "[=====>    ]  50 %  close 4/5  t = 1.500 s  0.25 x real time  6 s left");
}

TEST(ProgressText, LeavesOutWhatNobodyKnows) {
  ProgressValues values = half_way();
  EXPECT_EQ(progress_text(values), "close 4/5  t = 1.500 s");
  values.speed = 2.0;
  EXPECT_EQ(progress_text(values), "close 4/5  t = 1.500 s  2 x real time");
}

TEST(ProgressText, BarIsFullAtTheEndAndNeverLonger) {
  ProgressValues values = half_way();
  values.end = values.time;
  EXPECT_EQ(progress_text(values).substr(0, 19), "[==========] 100 % ");
  values.time = 99.0;
  EXPECT_EQ(progress_text(values).substr(0, 19), "[==========] 100 % ");
}

Mission mission_with(const std::string& phases) {
  std::string text = testing::small_mission();
  const auto begin = text.find("[[phase]]"), end = text.find("[[probe]]");
  return parse_mission(text.replace(begin, end - begin, phases));
}

TEST(LatestEnd, AddsThePhasesUp) {
  EXPECT_EQ(latest_end(mission_with("[[phase]]\nkind = \"free\"\nuntil = \"phase_time >= 0.5\"\n"
                                    "[[phase]]\nkind = \"free\"\nuntil = \"phase_time >= 1.0\"\n")),
            1.5);
  EXPECT_EQ(latest_end(mission_with("[[phase]]\nkind = \"free\"\nuntil = \"time >= 0.5\"\n"
                                    "[[phase]]\nkind = \"free\"\nuntil = \"time >= 2.0\"\n")),
            2.0);
  EXPECT_FALSE(
      latest_end(mission_with("[[phase]]\nkind = \"free\"\nuntil = \"widest\"\n")).has_value());
}

}  // namespace
}  // namespace retiarius::program
