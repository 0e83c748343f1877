#include "retiarius/campaign/report.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "retiarius/base/error.hpp"
#include "retiarius/campaign/report_data.hpp"
#include "retiarius/campaign/report_success.hpp"
#include "retiarius/campaign/report_tables.hpp"
#include "tests/campaign/sample_campaign.hpp"

namespace retiarius {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::sample_campaign;

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

TEST(CampaignReport, TellsTheRateWithItsInterval) {
  const CampaignTable table = sample_campaign(300);
  std::int64_t successes = 0, answered = 0;
  for (const CampaignRow& row : table.runs) {
    answered += row.success ? 1 : 0;
    successes += row.success.value_or(false) ? 1 : 0;
  }
  const Interval i = wilson_interval(successes, answered);
  const std::string html = campaign_html(table);
  EXPECT_THAT(
      html, HasSubstr(fmt::format("{} of {} runs; the probability lies between <b>{}</b> "
                                  "and <b>{}</b>",
                                  successes, answered, percent_text(i.low), percent_text(i.high))));
  EXPECT_THAT(html, HasSubstr("3 runs came to no answer and are not counted"));
}

TEST(CampaignReport, IsOneFileThatNeedsNothingElse) {
  const std::string html = campaign_html(sample_campaign(200));
  for (const char* outside : {"http://", "https://", "<script", "<link", "src=", "url("})
    EXPECT_THAT(html, Not(HasSubstr(outside)));
  EXPECT_THAT(html, HasSubstr("Aim &lt;and&gt; spin"));
  EXPECT_THAT(html, Not(HasSubstr("<and>")));
  EXPECT_THAT(html, Not(HasSubstr("nan")));
  EXPECT_THAT(html, HasSubstr("prefers-color-scheme:dark"));
}

TEST(CampaignReport, GivesEveryPictureIdsOfItsOwn) {
  const std::string html = campaign_html(sample_campaign(600, CampaignDesign::saltelli));
  std::set<std::string> ids;
  std::size_t count = 0;
  for (std::size_t at = html.find("id=\""); at != std::string::npos;
       at = html.find("id=\"", at + 1), ++count)
    ids.insert(html.substr(at + 4, html.find('"', at + 4) - at - 4));
  EXPECT_EQ(ids.size(), count);
  EXPECT_GT(count, 40u);
}

TEST(CampaignReport, IsTheSameForTheSameTable) {
  const CampaignTable table = sample_campaign(600, CampaignDesign::saltelli);
  EXPECT_EQ(campaign_html(table), campaign_html(table));
}

// Spin and the two errors of aim decide, the speed does not; the errors only by their size.
TEST(CampaignReport, FindsWhatSuccessDependsOn) {
  const CampaignTable table = sample_campaign(1000);
  const ReportColumns columns = report_columns(table);
  ASSERT_EQ(columns.ranked.size(), 4u);
  EXPECT_EQ(columns.ranked.back(), 3u);
  const auto found = influences(columns, columns.success);
  for (std::size_t k = 0; k < 4; ++k) {
    const bool aim = columns.ranked[k] < 2;
    if (columns.ranked[k] == 3) continue;
    EXPECT_EQ(found[k].off_median, aim);
    EXPECT_LT(found[k].correlation.interval.high, 0.0);
  }
  EXPECT_TRUE(found.back().correlation.interval.contains(0.0));
  EXPECT_THAT(campaign_html(table), HasSubstr("target.position[0] off its median"));
}

TEST(CampaignReport, OfSaltelliCountsIndependentRunsOnly) {
  const CampaignTable table = sample_campaign(600, CampaignDesign::saltelli);
  const ReportColumns columns = report_columns(table);
  EXPECT_EQ(columns.runs.size(), 200u);
  for (const CampaignRow* row : columns.runs) EXPECT_LT(row->id % 6, 2);
  const std::string html = campaign_html(table);
  EXPECT_THAT(html, HasSubstr("Sobol indices of success"));
  EXPECT_THAT(html, HasSubstr("Of 600 runs, 200 draw their inputs independently"));
  EXPECT_THAT(html, HasSubstr("blocks left out, which lack a value"));
  EXPECT_THAT(campaign_html(sample_campaign(600)), Not(HasSubstr("Sobol indices of")));
}

TEST(CampaignReport, CountsRunsAndSuccessesOfEachCell) {
  CampaignTable table;
  table.inputs = {"x", "y"};
  table.design = CampaignDesign::prescribed;
  for (std::int64_t id = 0; id < 54; ++id) {  // a grid of 3 by 3, six runs each
    const auto x = static_cast<double>(id % 3), y = static_cast<double>(id / 3 % 3);
    table.runs.push_back({id, {x, y}, {}, "finished", x + y < 2.0, "", "", ""});
  }
  const ReportColumns columns = report_columns(table);
  const CampaignFigure map = success_map(columns, 0, 1, "m");
  EXPECT_EQ(count_of(map.svg, ">of 6</text>"), 9u);
  EXPECT_EQ(count_of(map.svg, ">100 %</text>"), 3u);
  EXPECT_EQ(count_of(map.svg, ">0 %</text>"), 6u);
  EXPECT_THAT(campaign_html(table), HasSubstr("a share of these runs and no probability"));
}

TEST(CampaignReport, ListsTheWorstWithWhatRepeatsThem) {
  const CampaignTable table = sample_campaign(400);
  const std::string html = campaign_html(table);
  // Runs without an answer come first; 13 is the first of them.
  EXPECT_LT(html.find("--id 13<"), html.find("--id 1<"));
  EXPECT_THAT(html, HasSubstr("<a href=\"runs/13/report.html\">replay</a>"));
  EXPECT_THAT(html, HasSubstr("took longer than 60 s"));
  EXPECT_THAT(html, HasSubstr("failed: step at t = # s does not converge at node #"));
}

TEST(CampaignReport, TakesReasonsThatDifferInNumbersTogether) {
  EXPECT_EQ(without_numbers("t = 0.125 s, h = 1e-05, node 7"), "t = # s, h = #, node #");
  EXPECT_EQ(without_numbers("ends at 3."), "ends at #.");
  EXPECT_EQ(without_numbers("7e"), "#e");
  EXPECT_EQ(without_numbers("killed"), "killed");
}

TEST(CampaignReport, OfLittleOrNothingIsStillAPage) {
  CampaignTable table;
  EXPECT_THAT(campaign_html(table), HasSubstr("No run tells success"));
  table.inputs = {"a", "b"};
  table.measures = {"m"};
  table.runs.push_back({4, {1.0, 2.0}, {NAN}, "failed", std::nullopt, "mesh is open", "again", ""});
  EXPECT_THAT(campaign_html(table), HasSubstr("mesh is open"));
  table.runs.push_back({5, {1.0, 3.0}, {1.0}, "finished", true, "", "", ""});
  const std::string html = campaign_html(table);
  EXPECT_THAT(html, HasSubstr("100.0 % succeed"));
  EXPECT_THAT(html, Not(HasSubstr("nan")));
}

TEST(CampaignReport, RefusesATableThatDoesNotFit) {
  CampaignTable table = sample_campaign(3);
  table.runs[1].inputs.pop_back();
  try {
    campaign_html(table);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("run 1 has 3 inputs and 3 measures"));
  }
  table = sample_campaign(3);
  std::swap(table.runs[0], table.runs[2]);
  EXPECT_THROW(campaign_html(table), InputError);
}

TEST(CampaignReport, WritesAFile) {
  const auto path = std::filesystem::path(::testing::TempDir()) / "retiarius_campaign.html";
  const CampaignTable table = sample_campaign(50);
  write_campaign_report(table, path);
  std::ifstream stream(path);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  EXPECT_EQ(text, campaign_html(table));
  std::filesystem::remove(path);
  EXPECT_THROW(write_campaign_report(table, "/nonexistent/campaign.html"), RunError);
}

}  // namespace
}  // namespace retiarius
