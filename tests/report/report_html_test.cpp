#include "retiarius/report/report_html.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "retiarius/report/report_heading.hpp"
#include "retiarius/report/report_plots.hpp"

namespace retiarius {
namespace {

using ::testing::Contains;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::Not;

ReportData some_data() {
  ReportData data;
  data.title = "Net & <target>";
  data.run.phases = {{"shoot", PhaseKind::shoot, 0, 0.5, "time >= 0.5", {}},
                     {"spread", PhaseKind::spread, 0.5, 1, "widest", {{"turns", "1", 2.5}}}};
  data.run.measures = {{"peak_tension", "N", 123.456},
                       {"first_contact_time", "s", {}},
                       {"success", "", true},
                       {"mouth_area_max", "m2", 4.0}};
  data.resolved = "title = \"Net & <target>\"\n";
  data.build.version = "1.2.3";
  data.columns = {"time",       "step",
                  "mouth_area", "smallest_distance",
                  "momentum_x", "newton_iterations",
                  "a.x",        "a.y",
                  "a.z",        "a.fx",
                  "a.fy",       "a.fz"};
  data.rows = {{0, 0, 1, NAN, 5, 0, 1, 2, 3, 0, 0, 0}, {1, 2, 4, NAN, 5, 8, 1, 2, 3, 0, 0, 0}};
  return data;
}

TEST(ReportHtml, IsOneFileThatAsksTheNetworkForNothing) {
  const std::string html = report_html(some_data());
  for (const char* reference : {"http:", "https:", "src=", "href=", "url(", "@import", "<script"})
    EXPECT_THAT(html, Not(HasSubstr(reference)));
  EXPECT_TRUE(html.starts_with("<!doctype html>"));
  EXPECT_THAT(html, HasSubstr("prefers-color-scheme:dark"));
  EXPECT_THAT(html, HasSubstr("name=\"viewport\""));
}

TEST(ReportHtml, ShowsOutcomeMeasuresPhasesMissionAndVersions) {
  const std::string html = report_html(some_data());
  EXPECT_THAT(html, HasSubstr("<h1>Net &amp; &lt;target&gt;</h1>"));
  EXPECT_THAT(html, HasSubstr("<p class=\"outcome finished\"><b>Finished</b>"));
  EXPECT_THAT(html, HasSubstr("<dt>Peak tension</dt><dd>123.5 <small>N</small></dd>"));
  EXPECT_THAT(html, HasSubstr("<dt>Success</dt><dd>yes</dd>"));
  EXPECT_THAT(html, HasSubstr("First contact time</th><td class=\"num\">\u2013</td>"));
  EXPECT_THAT(html, HasSubstr("<dd>4 <small>m\u00b2</small></dd>"));
  EXPECT_THAT(html, HasSubstr("<code>widest</code>"));
  EXPECT_THAT(html, HasSubstr("Measures of phase spread"));
  EXPECT_THAT(html, HasSubstr("title = &quot;Net &amp; &lt;target&gt;&quot;"));
  EXPECT_THAT(html, HasSubstr("1.2.3"));
  EXPECT_THAT(html, Not(HasSubstr("<target>")));
}

TEST(ReportHtml, SaysWhyARunFailed) {
  ReportData data = some_data();
  data.run.outcome = Outcome::failed;
  data.run.reason = "node 3 at t = 0.2 s";
  EXPECT_THAT(report_html(data), HasSubstr("<p class=\"outcome failed\"><b>Failed</b><span>"
                                           "node 3 at t = 0.2 s</span>"));
}

TEST(ReportHtml, IsMadeForARunWithoutAnyRow) {
  EXPECT_THAT(report_html(ReportData{}), HasSubstr("No row was recorded."));
}

TEST(ReportPlots, AreThoseThatHaveData) {
  const std::vector<Plot> plots = report_plots(some_data());
  EXPECT_THAT(plots, Contains(Field(&Plot::title, "Mouth area")));
  EXPECT_THAT(plots, Contains(Field(&Plot::title, "Probe a: position")));
  EXPECT_THAT(plots, Not(Contains(Field(&Plot::title, "Smallest distance to a body"))));
  EXPECT_THAT(plots, Not(Contains(Field(&Plot::title, "Probe a: support force"))));
}

TEST(ReportPlots, ShowChangesAndRates) {
  for (const Plot& plot : report_plots(some_data())) {
    EXPECT_THAT(plot.marks, ::testing::ElementsAre(0.5));
    if (plot.title == "Change of linear momentum") {
      EXPECT_EQ(plot.series.at(0).y.at(1), 0.0);
    }
    if (plot.title == "Newton iterations per step") {
      EXPECT_EQ(plot.series.at(0).y.at(1), 4.0);
    }
  }
}

TEST(PrintedUnit, HasSuperscripts) {
  EXPECT_EQ(printed_unit("kg m2/s"), "kg m\u00b2/s");
  EXPECT_EQ(printed_unit("1"), "");
}

TEST(ReportHtml, WritesPowersOfTenAsPeopleDo) {
  EXPECT_EQ(measure_html({"drift", "1", 1.872e-13}), "1.872\u00b710\u207b\u00b9\u00b3");
  EXPECT_EQ(measure_html({"area", "m2", -2.5e20}),
            "\u22122.5\u00b710\u00b2\u2070 <small>m\u00b2</small>");
  EXPECT_EQ(measure_html({"mass", "kg", 0.0123456}), "0.01235 <small>kg</small>");
}

TEST(ReportHtml, TellsWhatThePageLacks) {
  EXPECT_THAT(report_html(some_data(), "without <3D>"),
              HasSubstr("<p class=\"note\">without &lt;3D&gt;</p>"));
}

}  // namespace
}  // namespace retiarius
