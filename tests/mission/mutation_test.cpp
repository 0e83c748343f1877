// Damaged missions either read or fail with an InputError; nothing else may happen.
#include <random>

#include <gtest/gtest.h>

#include "retiarius/mission/reader.hpp"
#include "retiarius/mission/trigger.hpp"
#include "retiarius/mission/writer.hpp"
#include "texts.hpp"

namespace retiarius {
namespace {

std::string damaged(std::string text, std::mt19937& random) {
  const std::string bytes = "0123456789.-+e=[]{}\"'\n#,_ xinf\xc3\xff\\";
  const auto below = [&random](std::size_t n) { return random() % n; };
  for (std::size_t count = 1 + below(4); count > 0 && !text.empty(); --count) {
    const std::size_t at = below(text.size());
    switch (below(4)) {
      case 0:
        text[at] = bytes[below(bytes.size())];
        break;
      case 1:
        text.insert(at, 1, bytes[below(bytes.size())]);
        break;
      case 2:
        text.erase(at, 1 + below(12));
        break;
      default:
        text.insert(at, text.substr(below(text.size()), below(40)));
        break;
    }
  }
  return text;
}

TEST(Mutation, DamagedFilesReadOrFailAsInput) {
  const std::string whole = to_toml(parse_mission(starter_mission("a")));
  std::mt19937 random(1);
  int read = 0, failed = 0;
  for (int i = 0; i < 4000; ++i) {
    const std::string text = damaged(i % 2 == 0 ? whole : starter_mission("a"), random);
    try {
      parse_mission(to_toml(parse_mission(text, "m.toml")));  // what reads also reads again
      ++read;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).rfind("m.toml:", 0), 0u) << error.what();
      ++failed;
    }
  }
  EXPECT_GT(read, 200);
  EXPECT_GT(failed, 1000);
}

TEST(Mutation, DamagedOverridesReadOrFailAsInput) {
  std::mt19937 random(2);
  int read = 0, failed = 0;
  for (int i = 0; i < 4000; ++i) {
    const char* const from[] = {"net.thread.radius=0.004", "phase[0].fix=['corners', 3]",
                                "target[0].radius=2", "phase[1].integrator.step=0.001"};
    const std::string text = damaged(from[i % 4], random);
    try {
      parse_mission(starter_mission("a"), "m.toml", ".", {text});
      ++read;
    } catch (const InputError& error) {
      ++failed;
    }
  }
  EXPECT_GT(read, 100);
  EXPECT_GT(failed, 1000);
}

TEST(Mutation, DamagedTriggersReadOrFailAsInput) {
  std::mt19937 random(3);
  int failed = 0;
  for (int i = 0; i < 20000; ++i) {
    const std::string text = damaged("contact or (time >= 1.5e0 and widest)", random);
    try {
      Trigger::parse(text).evaluate({});
    } catch (const InputError&) {
      ++failed;
    }
  }
  EXPECT_GT(failed, 10000);
}

}  // namespace
}  // namespace retiarius
