#include "retiarius/mission/trigger.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace retiarius {
namespace {

bool holds(const std::string& text, const TriggerValues& values) {
  return Trigger::parse(text).evaluate(values);
}

std::string error_of_trigger(const std::string& text, const SourcePlace& place = {}) {
  try {
    Trigger::parse(text, place);
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(Trigger, ComparesEveryQuantity) {
  for (const TriggerName& name : trigger_names()) {
    if (!name.value) continue;
    TriggerValues v;
    for (const auto& [value, above, equal] :
         {std::tuple{1.5, false, false}, {2.0, false, true}, {2.5, true, false}}) {
      v.*(name.value) = value;
      EXPECT_EQ(holds(name.name + " > 2", v), above) << name.name << value;
      EXPECT_EQ(holds(name.name + ">=2.0", v), above || equal) << name.name << value;
      EXPECT_EQ(holds(name.name + " < 2e0", v), !above && !equal) << name.name << value;
      EXPECT_EQ(holds(name.name + " <= +2", v), !above) << name.name << value;
    }
  }
}

TEST(Trigger, ReadsSignsAndExponents) {
  TriggerValues v;
  v.distance = -0.5;
  EXPECT_TRUE(holds("distance >= -5e-1", v));
  EXPECT_FALSE(holds("distance > -.5", v));
  EXPECT_TRUE(holds("distance < 1.5E+3", v));
}

TEST(Trigger, KnowsTheWords) {
  TriggerValues v;
  EXPECT_FALSE(holds("contact", v));
  EXPECT_FALSE(holds("widest", v));
  v.contact = true;
  EXPECT_TRUE(holds("contact", v));
  EXPECT_FALSE(holds("widest", v));
  v.widest = true;
  EXPECT_TRUE(holds("widest", v));
}

// All eight truth values of three words; time stands for the third.
TEST(Trigger, AndBindsTighterThanOr) {
  for (int bits = 0; bits < 8; ++bits) {
    const bool a = bits & 1, b = bits & 2, c = bits & 4;
    TriggerValues v;
    v.contact = a, v.widest = b, v.time = c ? 1.0 : 0.0;
    EXPECT_EQ(holds("contact or widest and time >= 1", v), a || (b && c)) << bits;
    EXPECT_EQ(holds("contact and widest or time >= 1", v), (a && b) || c) << bits;
    EXPECT_EQ(holds("(contact or widest) and time >= 1", v), (a || b) && c) << bits;
    EXPECT_EQ(holds("((contact)) and (widest or (time >= 1))", v), a && (b || c)) << bits;
    EXPECT_EQ(holds("contact or widest or time >= 1", v), a || b || c) << bits;
    EXPECT_EQ(holds("contact and widest and time >= 1", v), a && b && c) << bits;
  }
}

TEST(Trigger, TimesForgiveRoundOff) {
  TriggerValues v;
  v.time = 3 * 0.1;  // not 0.3
  ASSERT_NE(v.time, 0.3);
  EXPECT_FALSE(holds("time > 0.3", v));
  EXPECT_TRUE(holds("time <= 0.3", v));
  v.time = 0.3 - 1e-15;
  EXPECT_TRUE(holds("time >= 0.3", v));
  EXPECT_FALSE(holds("time < 0.3", v));
  v.phase_time = 5000.0 - 1e-6;
  EXPECT_TRUE(holds("phase_time >= 5000", v));
  v.phase_time = 5000.0 - 1e-5;
  EXPECT_FALSE(holds("phase_time >= 5000", v));
  v.distance = 0.3 - 1e-15;  // other quantities are what they are
  EXPECT_FALSE(holds("distance >= 0.3", v));
}

TEST(Trigger, TellsWhatItUses) {
  const Trigger t = Trigger::parse("contact or (time >= 1 and mouth_ratio < 0.5)");
  EXPECT_TRUE(t.uses("contact"));
  EXPECT_TRUE(t.uses("mouth_ratio"));
  EXPECT_FALSE(t.uses("widest"));
  EXPECT_FALSE(t.uses("mouth_area"));
  EXPECT_EQ(t.text(), "contact or (time >= 1 and mouth_ratio < 0.5)");
}

TEST(Trigger, TellsWhenItIsCertain) {
  const auto latest = [](const std::string& text) {
    return Trigger::parse(text).latest_time(10.0);
  };
  EXPECT_EQ(latest("time >= 12"), 12.0);
  EXPECT_EQ(latest("phase_time > 3"), 13.0);
  EXPECT_EQ(latest("contact or phase_time >= 3"), 13.0);
  EXPECT_EQ(latest("time >= 12 or time >= 11"), 11.0);
  EXPECT_EQ(latest("time >= 12 and phase_time >= 5"), 15.0);
  EXPECT_EQ(latest("time >= 2"), 10.0);
  EXPECT_EQ(latest("contact and time >= 12"), std::nullopt);
  EXPECT_EQ(latest("time <= 12"), std::nullopt);
  EXPECT_EQ(latest("distance >= 12"), std::nullopt);
}

struct BadTrigger {
  std::string text;
  int character;
  std::string why;
};

TEST(Trigger, ErrorsPointAtTheCharacter) {
  const std::vector<BadTrigger> cases = {
      {"", 1, "a trigger must not be empty, write for example time >= 2.0"},
      {"   ", 4, "a trigger must not be empty, write for example time >= 2.0"},
      {"tme >= 2", 1, "unknown name tme, did you mean time?"},
      {"contact or wide", 12, "unknown name wide, did you mean widest?"},
      {"contact or zzzzzzzz", 12,
       "unknown name zzzzzzzz; allowed: time, phase_time, mouth_area, mouth_ratio, distance, "
       "contact, widest"},
      {"time", 5, "expected >=, >, <= or < after time, found the end"},
      {"time == 2", 6, "expected >=, >, <= or < after time, found \"=\""},
      {"time >> 3", 7, "expected a number, found \">\""},
      {"time >= ", 9, "expected a number, found the end"},
      {"time >= 2s", 9, "expected a number, found \"2s\""},
      {"time >= 1e999", 9, "number out of range"},
      {"time >= inf", 9, "expected a number, found \"inf\""},
      {"time >= nan", 9, "expected a number, found \"nan\""},
      {"time >= - 2", 9, "expected a number, found \"-\""},
      {"time >= 0x10", 9, "expected a number, found \"0x10\""},
      {"contact widest", 9, "expected and, or, or the end, found \"widest\""},
      {"contact or", 11, "expected a quantity, a word or (, found the end"},
      {"and contact", 1, "expected a quantity, a word or (, found \"and\""},
      {"contact or (time >= 2", 12, "this parenthesis is not closed"},
      {"contact)", 8, "expected and, or, or the end, found \")\""},
      {"()", 2, "expected a quantity, a word or (, found \")\""},
      {"contact >= 1", 9, "expected and, or, or the end, found \">\""},
  };
  for (const BadTrigger& bad : cases) {
    EXPECT_EQ(error_of_trigger(bad.text), fmt::format("trigger = \"{}\": at character {}: {}",
                                                      bad.text, bad.character, bad.why));
  }
}

TEST(Trigger, ErrorsCarryLineAndColumn) {
  EXPECT_THAT(error_of_trigger("time >> 3", {"m.toml", 12, 10}),
              testing::StartsWith("m.toml:12:16: "));
  EXPECT_THAT(error_of_trigger("time >> 3", {"m.toml", 12, 0}), testing::StartsWith("m.toml:12: "));
}

TEST(Trigger, DeepParenthesesAreRefusedNotFatal) {
  EXPECT_EQ(error_of_trigger(std::string(100, '(') + "contact" + std::string(100, ')')), "");
  EXPECT_THAT(error_of_trigger(std::string(100000, '(')), testing::HasSubstr("too many"));
}

}  // namespace
}  // namespace retiarius
