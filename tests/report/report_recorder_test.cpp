#include "retiarius/report/report_recorder.hpp"

#include <gmock/gmock.h>

#include "retiarius/record/file.hpp"
#include "tests/record/sample_run.hpp"

namespace retiarius {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::SampleRun;
using testing::TemporaryFolder;

TEST(ThinnedItems, StayBoundedAndEven) {
  Thinned<int> items(10);
  for (int k = 0; k < 1000; ++k) items.add(k);
  EXPECT_LE(items.items().size(), 10u);
  EXPECT_GE(items.items().size(), 5u);
  EXPECT_EQ(items.items()[0], 0);
  for (std::size_t k = 1; k < items.items().size(); ++k)
    EXPECT_EQ(items.items()[k], static_cast<int>(k) * items.items()[1]);
}

TEST(ThinnedItems, KeepTheirContent) {
  Thinned<std::vector<int>> items(4);
  for (int k = 0; k < 100; ++k) items.add({k, k});
  for (const auto& item : items.items()) EXPECT_EQ(item.size(), 2u);
}

std::vector<double> times(const std::vector<Picture>& pictures) {
  std::vector<double> list;
  for (const Picture& p : pictures) list.push_back(p.time);
  return list;
}

TEST(ChosenPictures, AreEndsOfPhasesThenWhatFillsGaps) {
  std::vector<Picture> pictures;
  for (int k = 0; k <= 10; ++k) pictures.push_back({static_cast<double>(k), k < 3 ? 0 : 1, {}, {}});
  EXPECT_THAT(times(chosen_pictures(pictures, 3)), ElementsAre(0, 2, 10));
  EXPECT_THAT(times(chosen_pictures(pictures, 4)), ElementsAre(0, 2, 6, 10));
  EXPECT_EQ(chosen_pictures(pictures, 20).size(), 11u);
}

TEST(ReportRecorder, WritesThePageAtTheEnd) {
  TemporaryFolder folder;
  const SampleRun run(8);
  ReportRecorder recorder(folder.path(), "title = 1\n",
                          {"0.1.0", "abc", "gcc", "Release", {}, "plain", {}});
  run.feed(recorder, 31);
  EXPECT_FALSE(std::filesystem::exists(folder / "report.html"));
  recorder.end(run.report());
  const std::string html = read_whole_file(folder / "report.html");
  EXPECT_THAT(html, HasSubstr("Sample &lt;net&gt; &amp; box"));
  EXPECT_THAT(html, HasSubstr("Probe center: position"));
  EXPECT_THAT(html, HasSubstr("t = 3 s"));
  std::size_t scenes = 0;
  for (std::size_t at = html.find("class=\"scene\""); at != std::string::npos;
       at = html.find("class=\"scene\"", at + 1))
    ++scenes;
  EXPECT_EQ(scenes, 6u);
}

TEST(ReportRecorder, StaysSmallForABigNet) {
  TemporaryFolder folder;
  const SampleRun run(150);
  ReportRecorder recorder(folder.path(), "", {});
  run.feed(recorder, 41);
  recorder.end(run.report());
  EXPECT_LT(std::filesystem::file_size(folder / "report.html"), 2'000'000u);
}

}  // namespace
}  // namespace retiarius
