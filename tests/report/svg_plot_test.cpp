#include "retiarius/report/svg_plot.hpp"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

namespace retiarius {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Plot ramp() {
  Plot plot;
  plot.title = "Area <1>";
  plot.unit = "m";
  plot.x = {0, 1, 2};
  plot.series = {{"a & b", {0, 5, 10}, -1}, {"c", {1, 1, NAN}, -1}};
  plot.marks = {0.5};
  return plot;
}

TEST(PlotSvg, PutsValuesWhereTheAxesSay) {
  const std::string svg = plot_svg(ramp());
  // The box of the plot is 52..430 by 196..22: from (0, 0) through the middle to (2, 10).
  EXPECT_THAT(svg, HasSubstr("class=\"line s0\" d=\"M52.0 196.0L241.0 109.0L430.0 22.0\""));
  EXPECT_THAT(svg, HasSubstr("class=\"line s1\" d=\"M52.0 178.6L241.0 178.6\""));
  EXPECT_THAT(svg, HasSubstr("class=\"mark\" d=\"M146.5 22V196\""));
}

TEST(PlotSvg, StartsAZeroBasedAxisAtZeroEvenWhenNothingHappens) {
  Plot plot = ramp();
  plot.zero_based = true;
  for (PlotSeries& series : plot.series) series.y = {0, 0, 0};
  EXPECT_THAT(plot_svg(plot), HasSubstr("class=\"line s0\" d=\"M52.0 196.0L"));
}

TEST(PlotSvg, HasATextAlternativeAndSafeText) {
  const std::string svg = plot_svg(ramp());
  EXPECT_THAT(svg, HasSubstr("role=\"img\" aria-label=\"Area &lt;1&gt; over time / s. a &amp; b: "
                             "from 0 to 10 m, last 10."));
  EXPECT_THAT(svg, Not(HasSubstr("<1>")));
}

TEST(PlotSvg, DrawsASingleSampleAsADot) {
  Plot plot = ramp();
  plot.x = {0.0};
  plot.series.resize(1);
  plot.series[0].y = {3.0};
  EXPECT_THAT(plot_svg(plot), HasSubstr("<circle class=\"dot s0\""));
}

TEST(PlotSvg, BreaksLinesAtGaps) {
  Plot plot = ramp();
  plot.x = {0, 1, 2, 3, 4};
  plot.series.resize(1);
  plot.series[0].y = {0, 1, NAN, 1, 0};
  const std::string svg = plot_svg(plot);
  const std::string line = svg.substr(svg.find("class=\"line"));
  EXPECT_EQ(std::count(line.begin(), line.begin() + static_cast<long>(line.find("/>")), 'M'), 2);
}

TEST(PlotSvg, LetsASeriesKeepItsColor) {
  Plot plot = ramp();
  plot.series[1].color = 4;
  EXPECT_THAT(plot_svg(plot), HasSubstr("class=\"line s4\" d=\"M52.0 178.6"));
  EXPECT_THAT(legend_html(plot), HasSubstr("class=\"line s4\""));
}

TEST(LegendHtml, NamesSeveralSeriesButNotOne) {
  EXPECT_THAT(legend_html(ramp()), HasSubstr("</svg>a &amp; b</span>"));
  Plot plot = ramp();
  plot.series.resize(1);
  EXPECT_EQ(legend_html(plot), "");
}

TEST(HasData, IsFalseWhenNothingIsFinite) {
  Plot plot = ramp();
  EXPECT_TRUE(has_data(plot));
  for (PlotSeries& series : plot.series) series.y = {NAN, NAN, NAN};
  EXPECT_FALSE(has_data(plot));
}

TEST(Thinned, KeepsExtremesEndsAndGaps) {
  std::vector<double> y(10000, 0.0);
  y[1234] = 9.0;
  y[7777] = -9.0;
  y[5000] = NAN;
  const auto kept = thinned(y, 100);
  EXPECT_LT(kept.size(), 320u);
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
  for (std::size_t k : {0u, 1234u, 7777u, 5000u, 9999u})
    EXPECT_EQ(std::count(kept.begin(), kept.end(), k), 1) << k;
}

TEST(Thinned, KeepsShortSeriesWhole) { EXPECT_EQ(thinned({1, 2, 3}, 100).size(), 3u); }

}  // namespace
}  // namespace retiarius
