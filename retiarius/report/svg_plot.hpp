// Line plots as SVG text, coloured by CSS variables of the page they stand in.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace retiarius {

struct PlotSeries {
  std::string name;
  std::vector<double> y;  // one for each x; NaN leaves a gap
  int color = -1;         // number of its colour and dashes; -1: its place among the series
};

struct Plot {
  std::string title;
  std::string unit;  // of y; "1" or empty: none
  std::vector<double> x;
  std::string x_label = "time / s";
  std::vector<PlotSeries> series;
  std::vector<double> marks;  // vertical lines: where phases start
  bool zero_based = false;    // the axis holds 0
};

inline constexpr int kPlotColors = 7;  // CSS variables --c0 ... --c6

// Text made safe for HTML content and attributes.
std::string escape_html(std::string_view text);

// True when some series has a finite value.
bool has_data(const Plot& plot);

// The plot with axes, ticks and units, scaling with its container; `role="img"` with a text
// alternative. Long series are thinned so that no extreme is lost.
std::string plot_svg(const Plot& plot);

// Names of the series beside samples of their lines, as HTML; empty for a single series.
std::string legend_html(const Plot& plot);

// What the picture shows, in words: range and last value of each series.
std::string plot_alternative(const Plot& plot);

// Indices of at most about `limit` samples: the least and the greatest of each bucket of
// neighbours, and both ends; gaps (NaN) are kept as one sample.
std::vector<std::size_t> thinned(const std::vector<double>& y, std::size_t limit);

}  // namespace retiarius
