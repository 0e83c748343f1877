#include <gmock/gmock.h>

#include "tests/program/subprocess.hpp"

namespace retiarius {
namespace {

using ::testing::HasSubstr;
using testing::ProcessResult;
using testing::small_mission;
using ::testing::StartsWith;
using testing::WorkFolder;

class Render : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_.write("m.toml", small_mission());
    ASSERT_EQ(folder_.run({"run", "m.toml", "--out", "run"}).exit_code, 0);
  }
  std::string refusal(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = {"render", "run"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProcessResult result = folder_.run(arguments);
    EXPECT_EQ(result.exit_code, 2);
    return result.err;
  }

  WorkFolder folder_;
};

TEST_F(Render, WritesThePictureIntoTheRunByDefault) {
  const ProcessResult result = folder_.run({"render", "run", "--size", "300x200"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "run/picture.png written\n");
  EXPECT_THAT(folder_.read("run/picture.png"), StartsWith("\x89PNG"));
}

TEST_F(Render, NumbersSeveralPictures) {
  const ProcessResult result = folder_.run({"render", "run", "--time", "0", "0.1", "0.2", "--to",
                                            "svg", "--out", "p.svg", "--color", "speed"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "p-1.svg written\np-2.svg written\np-3.svg written\n");
  EXPECT_THAT(folder_.read("p-3.svg"), HasSubstr("<svg"));
  EXPECT_EQ(folder_.run({"render", "run", "--time", "0", "0.1", "--to", "pdf"}).out,
            "run/picture.pdf written\n");
}

TEST_F(Render, WritesTheStoryboard) {
  const ProcessResult result = folder_.run({"render", "run", "--storyboard", "--view", "front"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "run/storyboard.png written\n");
}

TEST_F(Render, RefusesWhatMakesNoSense) {
  EXPECT_THAT(refusal({"--size", "300"}), HasSubstr("--size 300 is not of the form WIDTHxHEIGHT"));
  EXPECT_THAT(refusal({"--size", "300x200x"}), HasSubstr("not of the form"));
  EXPECT_THAT(refusal({"--size", "9x9"}), HasSubstr("9x9 cannot be drawn"));
  EXPECT_THAT(refusal({"--time", "5"}), HasSubstr("from 0 to 0.2 s"));
  EXPECT_THAT(refusal({"--time", "0", "--storyboard"}), HasSubstr("leave out --time"));
  EXPECT_THAT(refusal({"--to", "gif", "--time", "0"}), HasSubstr("a film shows the whole run"));
  EXPECT_THAT(refusal({"--speed", "2"}), HasSubstr("--speed is for films"));
  EXPECT_THAT(refusal({"--view", "back"}), HasSubstr("iso"));
  EXPECT_FALSE(folder_.has("run/picture.png"));
}

}  // namespace
}  // namespace retiarius
