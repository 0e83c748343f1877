#include "retiarius/report/report_page.hpp"

#include <filesystem>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "retiarius/base/error.hpp"
#include "retiarius/record/file.hpp"
#include "retiarius/report/replay_page.hpp"
#include "retiarius/report/run_recorders.hpp"
#include "tests/record/sample_run.hpp"

namespace retiarius {
namespace {

namespace fs = std::filesystem;
using testing::error_text;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::SampleRun;
using testing::TemporaryFolder;

void record(const fs::path& folder, bool to_the_end = true) {
  RecordOptions options;
  options.resolved = "title = \"Sample\"\n";
  options.mission = "title = \"As given\"\n";
  options.build = {"0.1.0", "v0.1.0",        "gcc", "Release", {{"native", "off"}},
                   "plain", {{"fmt", "9.1"}}};
  const auto recorders = make_run_recorders(folder, options);
  const SampleRun run;
  run.feed(*recorders, 31);
  if (to_the_end) recorders->end(run.report());
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t number = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
    ++number;
  return number;
}

TEST(Base64, IsTheOneOfTheStandard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

// Made from the files, the page is the one that the run itself wrote.
TEST(ReportPage, IsTheSameMadeAgain) {
  TemporaryFolder base;
  record(base / "out");
  EXPECT_EQ(report_page(base / "out"), read_whole_file(base / "out/report.html"));
  fs::remove(base / "out/replay.bin");
  const std::string page = report_page(base / "out");
  EXPECT_THAT(page, HasSubstr("This page is without the 3D replay, because"));
  EXPECT_THAT(page, HasSubstr("Mouth area"));
}

TEST(ReportPage, HoldsTheRunAndForbidsTheNetwork) {
  if (!viewer_built_in()) GTEST_SKIP() << "built without the viewer";
  TemporaryFolder base;
  record(base / "out");
  const std::string page = read_whole_file(base / "out/report.html");
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
  EXPECT_THAT(page, HasSubstr("connect-src 'none'"));
  EXPECT_THAT(page, HasSubstr("Sample &lt;net&gt; &amp; box \u00b7 Retiarius"));
  EXPECT_LT(page.find("class=\"outcome finished\""), page.find("id=\"app\""));
  for (const char* file : {"replay.bin", "history.csv", "summary.json", "mission.toml"})
    EXPECT_EQ(count(page, fmt::format("data-run=\"out\" data-file=\"{}\"", file)), 1u) << file;
  EXPECT_THAT(page, HasSubstr(base64(read_whole_file(base / "out/replay.bin"))));
  EXPECT_EQ(count(page, "retiarius:"), 0u);  // no place left empty
}

TEST(ReportPage, TakesTheWholeChunksOfARunThatWasKilled) {
  if (!viewer_built_in()) GTEST_SKIP() << "built without the viewer";
  TemporaryFolder base;
  record(base / "out", false);
  const std::string whole = read_whole_file(base / "out/replay.bin");
  write_atomically(base / "out/replay.bin", whole + "FRAM torn");
  const std::string page = report_page(base / "out");
  EXPECT_THAT(page, HasSubstr(">" + base64(whole) + "<"));
  EXPECT_THAT(page, HasSubstr("there is no summary.json"));
  EXPECT_THAT(page, HasSubstr("Sample &lt;net&gt; &amp; box"));
  std::string damaged = whole;
  damaged[whole.size() / 2] = static_cast<char>(damaged[whole.size() / 2] ^ 8);
  write_atomically(base / "out/replay.bin", damaged);
  EXPECT_THAT(error_text<InputError>([&] { report_page(base / "out"); }),
              HasSubstr("out/replay.bin: the recording is damaged"));
}

TEST(ComparisonPage, HoldsAllRunsUnderNamesOfTheirOwn) {
  if (!viewer_built_in()) GTEST_SKIP() << "built without the viewer";
  TemporaryFolder base;
  record(base / "a/out");
  record(base / "b/out");
  const std::string page = comparison_page({base / "a/out", base / "b/out/"});
  EXPECT_EQ(count(page, "data-run=\"a/out\" data-file=\"replay.bin\""), 1u);
  EXPECT_EQ(count(page, "data-run=\"b/out\" data-file=\"replay.bin\""), 1u);
  EXPECT_THAT(page, HasSubstr("Comparison of 2 runs"));
  EXPECT_EQ(count(page, "class=\"outcome finished\""), 2u);
  EXPECT_THAT(error_text<InputError>([&] {
                comparison_page({base / "a/out", base / "a/out"});
              }),
              HasSubstr("cannot be compared with itself"));
  EXPECT_THAT(error_text<InputError>([&] {
                comparison_page({base / "a/out", base / "a"});
              }),
              HasSubstr("a/replay.bin"));
}

TEST(ComparisonPage, NeedsTwoRuns) {
  EXPECT_THAT(error_text<InputError>([] { comparison_page({"somewhere"}); }),
              HasSubstr("two runs or more"));
}

TEST(LivePage, AsksOnlyTheServerItComesFrom) {
  if (!viewer_built_in()) GTEST_SKIP() << "built without the viewer";
  const std::string page = live_page("Run");
  EXPECT_THAT(page, HasSubstr("connect-src 'self'"));
  EXPECT_THAT(page, Not(HasSubstr("data-file=\"replay.bin\"")));
}

}  // namespace
}  // namespace retiarius
