// A Chart as SVG text, good enough to print.
#pragma once

#include <string>

#include "retiarius/report/chart.hpp"

namespace retiarius {

enum class ChartLook {
  page,        // part of an HTML page: its font and its colours, light or dark (ChartPaint)
  standalone,  // a file of its own: with title, light colours and fonts named in it
};

// Axes with units, major and minor ticks and grid; the legend where no curve runs, else below.
// Lines are solid, told apart by colour and sparse markers; `dashed` curves by dashes, `points` by
// the shape of their markers. NaN, infinities and what a logarithmic axis cannot show leave gaps.
// Long curves are thinned so that no extreme is lost. `role="img"` with title and description;
// `id` makes their ids unique within a page.
std::string chart_svg(const Chart& chart, ChartLook look, const std::string& id = "chart");

// What the picture shows, in words: ranges and last value of each curve, caption and source.
std::string chart_alternative(const Chart& chart);

}  // namespace retiarius
