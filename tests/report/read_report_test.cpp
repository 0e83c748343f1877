#include "retiarius/report/read_report.hpp"

#include <gmock/gmock.h>

#include "retiarius/base/error.hpp"
#include "retiarius/record/file.hpp"
#include "retiarius/report/report_html.hpp"
#include "retiarius/report/report_page.hpp"
#include "retiarius/report/report_recorder.hpp"
#include "retiarius/report/run_recorders.hpp"
#include "tests/record/sample_run.hpp"

namespace retiarius {
namespace {

namespace fs = std::filesystem;
using testing::error_text;
using ::testing::HasSubstr;
using testing::SampleRun;
using testing::TemporaryFolder;

void record(const std::filesystem::path& folder, const SampleRun& run, bool to_the_end) {
  RecordOptions options;
  options.resolved = "title = \"Sample\"\n";
  options.build = {"0.1.0", "v0.1.0",        "gcc", "Release", {{"native", "off"}},
                   "plain", {{"fmt", "9.1"}}};
  const auto recorders = make_run_recorders(folder, options);
  run.feed(*recorders, 101);
  if (to_the_end) recorders->end(run.report());
}

// Without a recording the run itself writes the static page; made from the files it is the same.
TEST(ReadReport, GivesTheSameStaticPageAgain) {
  TemporaryFolder base;
  const SampleRun run;
  record(base / "out", run, true);
  const ReportData data = read_report(base / "out");
  ReportRecorder recorder(base.path(), data.resolved, data.build);
  run.feed(recorder, 101);
  recorder.end(run.report());
  fs::remove(base / "out/replay.bin");
  EXPECT_EQ(report_page(base / "out"), read_whole_file(base / "report.html"));
}

TEST(ReadReport, MakesAPageOfARunThatWasKilled) {
  TemporaryFolder base;
  record(base / "out", SampleRun(), false);
  const std::string page = report_html(read_report(base / "out"));
  EXPECT_THAT(page, HasSubstr("there is no summary.json"));
  EXPECT_THAT(page, HasSubstr("Sample &lt;net&gt; &amp; box"));
  EXPECT_THAT(page, HasSubstr("Mouth area"));
}

TEST(ReadReport, NamesWhatItCannotUse) {
  TemporaryFolder base;
  record(base / "out", SampleRun(), true);
  write_atomically(base / "out/summary.json", "{\"title\": 3");
  EXPECT_THAT(error_text<InputError>([&] { read_report(base / "out"); }),
              HasSubstr("cannot use " + (base / "out/summary.json").string()));
  EXPECT_THAT(error_text<InputError>([&] { read_report(base / "nothing"); }),
              HasSubstr("nothing/run.h5"));
}

}  // namespace
}  // namespace retiarius
