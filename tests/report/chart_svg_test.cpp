#include "retiarius/report/chart_svg.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "retiarius/base/error.hpp"
#include "retiarius/report/chart_axis.hpp"
#include "retiarius/report/chart_curves.hpp"
#include "retiarius/report/chart_legend.hpp"
#include "retiarius/report/chart_paint.hpp"

namespace retiarius {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

double same(double v) { return v; }

int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

Chart two_lines() {
  Chart chart;
  chart.title = "Height <of> a & b";
  chart.x_label = "time / s";
  chart.y_label = "height / m";
  chart.curves = {{"ours", {0, 1, 2}, {0, 1, 0}, CurveStyle::line},
                  {"reference", {0, 1, 2}, {0, 1, 0}, CurveStyle::points}};
  chart.caption = "h = 0.01 s.";
  chart.source = "by hand";
  return chart;
}

TEST(LinearAxis, HasMinorTicksBetweenMajorOnes) {
  const ChartAxis axis = linear_axis({0.0, 10.0}, 5, true);
  EXPECT_THAT(axis.labels, ElementsAre("0", "2", "4", "6", "8", "10"));
  EXPECT_EQ(axis.minor.size(), 15u);  // three between neighbours: steps of a half
  EXPECT_DOUBLE_EQ(axis.minor[0], 0.5);
  EXPECT_DOUBLE_EQ(axis.fraction(2.5), 0.25);
}

TEST(LogAxis, LabelsDecadesAndTicksTheirMultiples) {
  const ChartAxis axis = log_axis({2e-4, 0.3});
  EXPECT_DOUBLE_EQ(axis.low, 2e-4);
  EXPECT_NEAR(axis.high, 0.3, 1e-15);
  EXPECT_THAT(axis.labels, ElementsAre("10\u207b\u00b3", "10\u207b\u00b2", "10\u207b\u00b9"));
  EXPECT_EQ(axis.minor.size(), 8u + 8u + 8u + 2u);
  EXPECT_NEAR(axis.fraction(std::sqrt(2e-4 * 0.3)), 0.5, 1e-12);
  EXPECT_TRUE(std::isnan(axis.fraction(0.0)));
}

TEST(LogAxis, WritesPlainNumbersWhereTheyAreShort) {
  EXPECT_THAT(log_axis({1.0, 100.0}).labels, ElementsAre("1", "2", "5", "10", "20", "50", "100"));
}

TEST(LogAxis, LeavesOutDecadesWhereThereAreMany) {
  const ChartAxis axis = log_axis({1e-16, 1.0});
  EXPECT_LE(axis.labels.size(), 8u);
  EXPECT_GE(axis.labels.size(), 4u);
}

TEST(LogAxis, SurvivesOneValueAndNone) {
  const ChartAxis one = log_axis({3.0, 3.0});
  EXPECT_LT(one.low, 3.0);
  EXPECT_GT(one.high, 3.0);
  EXPECT_EQ(log_axis(Extent::none()).high, 10.0);
  EXPECT_EQ(log_axis({1.0, 1.0}).low, 1.0);
}

TEST(ChartSvg, PutsValuesWhereTheAxesSay) {
  const std::string svg = chart_svg(two_lines(), ChartLook::page);
  // Both labels of y are "0.0" ... "1.0"; the frame ends 16 before the right edge, 10 below the
  // top.
  const double left = 20.0 + text_width("0.0", 12.0) + 8.0;
  char path[80];
  std::snprintf(path, sizeof path, "d=\"M%.1f 260.0L%.1f 10.0L464.0 260.0\"", left,
                0.5 * (left + 464.0));
  EXPECT_THAT(svg, HasSubstr(path));
}

TEST(ChartSvg, HasATextAlternativeAndSafeText) {
  const std::string svg = chart_svg(two_lines(), ChartLook::page, "a-1");
  EXPECT_THAT(svg, HasSubstr("role=\"img\" aria-labelledby=\"a-1-t a-1-d\""));
  EXPECT_THAT(svg, HasSubstr("<title id=\"a-1-t\">Height &lt;of&gt; a &amp; b</title>"));
  EXPECT_THAT(svg, HasSubstr("height / m over time / s. ours: from 0 to 1 for abscissae from 0 to "
                             "2."));
  EXPECT_THAT(svg, HasSubstr("Source: by hand."));
  EXPECT_THAT(svg, Not(HasSubstr("<of>")));
}

TEST(ChartSvg, TakesColorsOfThePageOrNamesItsOwn) {
  const std::string page = chart_svg(two_lines(), ChartLook::page);
  EXPECT_THAT(page, HasSubstr("stroke:var(--c0,#0072b2)"));
  EXPECT_THAT(page, Not(HasSubstr("xmlns")));
  const std::string alone = chart_svg(two_lines(), ChartLook::standalone);
  EXPECT_THAT(alone, HasSubstr("xmlns=\"http://www.w3.org/2000/svg\""));
  EXPECT_THAT(alone, HasSubstr("font-family="));
  EXPECT_THAT(alone, HasSubstr("stroke:#0072b2"));
  EXPECT_THAT(alone, Not(HasSubstr("var(")));
  EXPECT_THAT(alone, HasSubstr(">Height &lt;of&gt; a &amp; b</text>"));
}

TEST(ChartSvg, PutsThePowerOfTenBeforeTheUnit) {
  Chart chart = two_lines();
  chart.curves = {{"", {0, 1}, {0, 2e-6}, CurveStyle::line}};
  EXPECT_THAT(chart_svg(chart, ChartLook::page), HasSubstr(">height / 10\u207b\u2076 m</text>"));
}

TEST(ChartSvg, WritesLabelsAsTheyArePrinted) {
  Chart chart = two_lines();
  chart.x_label = "P L^2 / EI / 1";
  chart.y_label = "mouth area / m2";
  const std::string svg = chart_svg(chart, ChartLook::page);
  EXPECT_THAT(svg, HasSubstr(">P L\u00b2 / EI</text>"));
  EXPECT_THAT(svg, HasSubstr(">mouth area / m\u00b2</text>"));
  chart.curves = {{"", {0, 1}, {0, 2e-6}, CurveStyle::line}};
  chart.y_label = "error / 1";
  EXPECT_THAT(chart_svg(chart, ChartLook::page), HasSubstr(">error / 10\u207b\u2076</text>"));
}

TEST(ChartSvg, ShowsPointsAsMarkersWithoutLine) {
  Chart chart = two_lines();
  chart.curves.erase(chart.curves.begin());
  chart.curves[0].name.clear();
  const std::string svg = chart_svg(chart, ChartLook::page);
  EXPECT_EQ(count(svg, "<circle"), 3);
  EXPECT_EQ(count(svg, "stroke-linejoin"), 0);
}

TEST(ChartSvg, DashesWhatIsDashedEachInItsWay) {
  Chart chart = two_lines();
  for (Curve& curve : chart.curves) curve.style = CurveStyle::dashed;
  const std::string svg = chart_svg(chart, ChartLook::page);
  EXPECT_THAT(svg, HasSubstr(std::string("stroke-dasharray:") + dashes(0) + "\""));
  EXPECT_THAT(svg, HasSubstr(std::string("stroke-dasharray:") + dashes(1) + "\""));
  EXPECT_STRNE(dashes(0), dashes(1));
}

TEST(ChartSvg, MakesAxesEqualWhenAsked) {
  Chart chart = two_lines();
  chart.equal_axes = true;
  // A square: drawn with sides of equal length.
  chart.curves = {{"", {0, 3, 3, 0, 0}, {0, 0, 3, 3, 0}, CurveStyle::line}};
  const std::string svg = chart_svg(chart, ChartLook::page);
  const std::size_t at = svg.find("stroke-linejoin:round\" d=\"M");
  ASSERT_NE(at, std::string::npos);
  double x0, y0, x1, y1, x2, y2;
  ASSERT_EQ(std::sscanf(svg.c_str() + at, "stroke-linejoin:round\" d=\"M%lf %lfL%lf %lfL%lf %lf",
                        &x0, &y0, &x1, &y1, &x2, &y2),
            6);
  EXPECT_GT(x1 - x0, 100.0);
  EXPECT_NEAR(x1 - x0, y1 - y2, 0.3);
}

TEST(ChartSvg, SaysNothingWrongWhereThereIsNothing) {
  Chart chart = two_lines();
  chart.log_y = true;
  for (Curve& curve : chart.curves) curve.y.assign(3, -1.0);
  const std::string svg = chart_svg(chart, ChartLook::standalone);
  EXPECT_THAT(svg, HasSubstr("ours: no values."));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
}

TEST(ChartSvg, RefusesCurvesOfUnequalLength) {
  Chart chart = two_lines();
  chart.curves[0].x.pop_back();
  try {
    chart_svg(chart, ChartLook::page);
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "the curve ours has 2 abscissae and 3 ordinates");
  }
}

TEST(DrawnCurves, BreakAtGapsAndAtWhatALogarithmCannotShow) {
  Chart chart;
  chart.log_y = true;
  chart.curves = {{"", {0, 1, 2, 3, 4, 5, 6}, {1, 2, NAN, 3, 4, 0, 5}, CurveStyle::dashed}};
  const auto curves = drawn_curves(chart, same, same);
  ASSERT_EQ(curves[0].lines.size(), 3u);
  EXPECT_EQ(curves[0].lines[1].size(), 2u);
  // A sample alone between gaps has no line: it is a marker.
  EXPECT_THAT(curves[0].markers, ElementsAre(std::pair(6.0, 5.0)));
}

TEST(DrawnCurves, KeepExtremesOfBothCoordinatesWhenThinned) {
  Chart chart;
  Curve curve{"", {}, {}, CurveStyle::line};
  for (int k = 0; k < 20000; ++k) {
    curve.x.push_back(std::cos(1e-3 * k));
    curve.y.push_back(std::sin(1e-3 * k));
  }
  curve.x[7777] = 9.0;
  curve.y[1234] = -9.0;
  chart.curves = {curve};
  const auto drawn = drawn_curves(chart, same, same);
  ASSERT_EQ(drawn[0].lines.size(), 1u);
  EXPECT_LT(drawn[0].lines[0].size(), 2500u);
  bool right = false, low = false;
  for (const auto& [x, y] : drawn[0].lines[0]) {
    right |= x == 9.0;
    low |= y == -9.0;
  }
  EXPECT_TRUE(right);
  EXPECT_TRUE(low);
}

TEST(DrawnCurves, MarkLinesSparselyWhereThereAreSeveral) {
  Chart chart;
  Curve curve{"", {}, {}, CurveStyle::line};
  for (int k = 0; k < 500; ++k) {
    curve.x.push_back(k);
    curve.y.push_back(k);
  }
  chart.curves = {curve};
  EXPECT_TRUE(drawn_curves(chart, same, same)[0].markers.empty());
  chart.curves.push_back(curve);
  const auto two = drawn_curves(chart, same, same);
  EXPECT_EQ(two[0].markers.size(), 4u);
  EXPECT_NE(two[0].markers, two[1].markers);
}

TEST(FreePlace, IsWhereNoCurveRuns) {
  const PixelBox frame{0, 0, 100, 100};
  EXPECT_EQ(free_place({}, frame, 20, 20)->right, 91.0);  // top right when it may choose
  const PixelLine across{{0, 15}, {100, 15}};
  const auto below = free_place({across}, frame, 20, 20);
  ASSERT_TRUE(below);
  EXPECT_GT(below->top, 15.0);
  std::vector<PixelLine> everywhere;
  for (int k = 0; k <= 10; ++k) everywhere.push_back({{0, 10.0 * k}, {100, 10.0 * k}});
  EXPECT_FALSE(free_place(everywhere, frame, 20, 20));
  EXPECT_FALSE(free_place({}, frame, 120, 20));
}

TEST(Touches, FindsALineThatPassesWithoutAPointInside) {
  const PixelBox box{40, 40, 60, 60};
  EXPECT_TRUE(touches({{0, 0}, {100, 100}}, box));
  EXPECT_FALSE(touches({{0, 50}, {30, 100}}, box));
  EXPECT_TRUE(touches({{50, 50}}, box));
}

TEST(ChartSvg, PutsTheLegendBelowWhereCurvesFillTheFrame) {
  Chart chart = two_lines();
  const std::string inside = chart_svg(chart, ChartLook::page);
  Curve zigzag{"zigzag", {}, {}, CurveStyle::line};
  for (int k = 0; k < 100; ++k) {
    zigzag.x.push_back(0.02 * k);
    zigzag.y.push_back(k % 2);
  }
  chart.curves.push_back(zigzag);
  const std::string below = chart_svg(chart, ChartLook::page);
  EXPECT_EQ(count(inside, "<rect"), 1);
  EXPECT_EQ(count(below, "<rect"), 0);
  EXPECT_THAT(inside, HasSubstr("viewBox=\"0 0 480 302\""));
  EXPECT_THAT(below, HasSubstr("viewBox=\"0 0 480 323\""));
}

TEST(InRows, StartsANewRowWhereOneIsFull) {
  const auto places = in_rows({50, 40, 30}, 100);
  EXPECT_EQ(places[1], std::pair(50.0, 0));
  EXPECT_EQ(places[2], std::pair(0.0, 1));
}

}  // namespace
}  // namespace retiarius
