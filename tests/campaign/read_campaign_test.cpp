// What a campaign file may say, and what its errors tell.
#include "retiarius/campaign/read_campaign.hpp"

#include <gmock/gmock.h>

#include "tests/campaign/texts.hpp"

namespace retiarius {
namespace {

using testing::campaign_text;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::least_campaign;
using testing::uniform_variable;

std::string error_of(const std::string& text) {
  try {
    parse_campaign(text, "c.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(ReadCampaign, TakesWhatTheFileSays) {
  const CampaignSpec c = parse_campaign(R"(
title = "t"
mission = "m.toml"
set = ["integrator.step=0.1"]
kernels = "portable"
[plan]
design = "sobol"
runs = 8
seed = 5
[[variable]]
set = ["target.position[0]", "phase[1].axis[2]"]
distribution = "truncated-normal"
mean = 1
deviation = 2
low = 0
high = 3
[[variable]]
name = "tumble"
set = "target.spin_deg"
distribution = "cone"
half_angle_deg = 20
length = 5
[keep]
what = "sample"
ids = [0, 7]
every = 3
[limits]
time = 2.5
steps = 10
wall_clock = 60
attempts = 3
[stop]
width = 0.1
confidence = 0.9
batch = 20
)",
                                        "c.toml", "/folder");
  EXPECT_EQ(c.title, "t");
  EXPECT_EQ(c.mission_path(), "/folder/m.toml");
  EXPECT_THAT(c.sets, ElementsAre("integrator.step=0.1"));
  EXPECT_EQ(c.kernels, "portable");
  EXPECT_EQ(c.plan.design, Design::sobol);
  EXPECT_EQ(c.plan.runs, 8);
  EXPECT_EQ(c.plan.seed, 5u);
  EXPECT_EQ(c.variables[0].name, "position0");
  EXPECT_THAT(c.variables[0].sets, ElementsAre("target.position[0]", "phase[1].axis[2]"));
  EXPECT_EQ(c.variables[0].high, 3.0);
  EXPECT_EQ(c.variables[1].length, 5.0);
  EXPECT_THAT(c.input_names(), ElementsAre("position0", "tumble.angle", "tumble.azimuth"));
  EXPECT_EQ(c.keep.what, Keep::sample);
  EXPECT_THAT(c.keep.ids, ElementsAre(0.0, 7.0));
  EXPECT_EQ(c.keep.every, 3);
  EXPECT_EQ(c.limits.time, 2.5);
  EXPECT_EQ(c.limits.steps, 10);
  EXPECT_EQ(c.limits.wall_clock, 60.0);
  EXPECT_EQ(c.limits.attempts, 3);
  EXPECT_EQ(c.stop.width, 0.1);
  EXPECT_EQ(c.stop.confidence, 0.9);
  EXPECT_EQ(c.stop.batch, 20);
}

TEST(ReadCampaign, ContentWithoutCommentsAndLayoutTellsCampaignsApart) {
  const CampaignSpec a = parse_campaign(least_campaign());
  EXPECT_EQ(parse_campaign("# a comment\n\n" + least_campaign()).canonical, a.canonical);
  EXPECT_NE(parse_campaign(least_campaign("[limits]\nsteps = 1\n")).canonical, a.canonical);
}

TEST(ReadCampaign, ErrorsNamePlaceKeyAndRemedy) {
  const std::string uniform = "set = \"net.side\"\ndistribution = \"uniform\"\nlow = 0\n";
  const std::pair<std::string, std::string> cases[] = {
      {"", "c.toml: is empty; a campaign needs at least mission, [plan] and a [[variable]]"},
      {"mission = 3\n", "c.toml:1:11: mission = 3: must be a text"},
      {"mission = \"m\"\n", "c.toml: plan is missing: add a table [plan]"},
      {least_campaign("[limit]\ntime = 1\n"),
       "c.toml:11:2: unknown key limit, did you mean limits?"},
      {least_campaign("[limits]\nwall_clok = 1\n"),
       "c.toml:12:1: unknown key limits.wall_clok, did you mean wall_clock?"},
      {least_campaign("[limits]\ntime = -1\n"),
       "c.toml:12:8: limits.time = -1: must be greater than 0 s"},
      {least_campaign("[stop]\nbatch = 5\n"), "stop.width is missing"},
      {least_campaign("[keep]\nwhat = \"sample\"\n"),
       "keep.what = \"sample\" needs keep.ids or keep.every"},
      {least_campaign("[keep]\nwhat = \"measures\"\nevery = 3\n"),
       "keep.every belongs to what sample, not measures"},
      {campaign_text("design = \"sobbol\"\nruns = 1", uniform_variable("side")),
       "c.toml:3:10: plan.design = \"sobbol\": must be one of"},
      {campaign_text("design = \"sobol\"", uniform_variable("side")), "plan.runs is missing"},
      {campaign_text("design = \"sobol\"\nruns = 1", ""),
       "variable is missing: a campaign needs at least one [[variable]]"},
      {campaign_text("design = \"sobol\"\nruns = 1", "[[variable]]\n" + uniform + "high = 0\n"),
       "c.toml:9:8: variable[0].high = 0.0: must be greater than low = 0.0"},
      {campaign_text("design = \"sobol\"\nruns = 1",
                     "[[variable]]\n" + uniform + "high = 1\nmean = 0\n"),
       "variable[0].mean belongs to distribution normal, truncated-normal, not uniform"},
      {least_campaign(uniform_variable("x")), "is called \"x\", as variable[0] is"},
      {least_campaign("[[variable]]\nname = \"a b\"\n" + uniform + "high = 1\n"),
       "variable[1].name = \"a b\": may have letters, digits, _ and - only"},
      {least_campaign("[[variable]]\nset = \"target.position[0]\"\nname = \"b\"\n"
                      "distribution = \"uniform\"\nlow = 0\nhigh = 1\n"),
       "variable[1].set = \"target.position[0]\": is set already"},
      {least_campaign("[[variable]]\nset = \"seed\"\ndistribution = \"uniform\"\nlow = 0\n"
                      "high = 1\n"),
       "every run has a seed of its own"},
      {campaign_text("design = \"grid\"", uniform_variable("side")),
       "variable[0].levels is missing: design \"grid\" needs it"},
      {campaign_text("design = \"list\"", uniform_variable("side")),
       "variable[0].distribution: design \"list\" takes \"values\" only"},
      {campaign_text("design = \"sobol\"\nruns = 2",
                     "[[variable]]\nset = \"net.side\"\ndistribution = \"values\"\nvalues = [1]\n"),
       "\"values\" is for the designs grid and list"},
      {least_campaign(uniform_variable("side") +
                      "[[group]]\nvariables = [\"x\", \"sid\"]\ncorrelation = [1, 0, 0, 1]\n"),
       "group[0].variables: there is no variable \"sid\", did you mean side?"},
      {least_campaign(uniform_variable("side") +
                      "[[group]]\nvariables = [\"x\", \"side\"]\ncorrelation = [1, 0.5, 0, 1]\n"),
       "group[0].correlation: must be symmetric"},
      {least_campaign(uniform_variable("side") +
                      "[[group]]\nvariables = [\"x\", \"side\"]\ncorrelation = [1, 1, 1, 1]\n"),
       "must be positive definite"},
      {least_campaign(uniform_variable("side") +
                      "[[group]]\nvariables = [\"x\", \"side\"]\ncorrelation = [1, 0.5, 1]\n"),
       "has 3 numbers; 2 variables need 2 x 2"},
  };
  for (const auto& [text, expected] : cases)
    EXPECT_THAT(error_of(text), HasSubstr(expected)) << text;
}

TEST(ReadCampaign, SobolSequenceHasItsDimensions) {
  std::string variables;
  for (int i = 0; i < 65; ++i) variables += uniform_variable(std::to_string(i));
  EXPECT_THAT(error_of(campaign_text("design = \"sobol\"\nruns = 1", variables)),
              HasSubstr("65 inputs need a sequence of 65 dimensions, and there are 64"));
  EXPECT_EQ(error_of(campaign_text("design = \"monte-carlo\"\nruns = 1", variables)), "no error");
}

}  // namespace
}  // namespace retiarius
