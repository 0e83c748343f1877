// The frame of a chart: where its two axes lie in the picture, and how they are drawn.
#pragma once

#include <string>

#include "retiarius/report/chart_axis.hpp"
#include "retiarius/report/chart_legend.hpp"
#include "retiarius/report/chart_paint.hpp"

namespace retiarius {

inline constexpr double kChartWidth = 480.0;  // of the viewBox: small, so that text stays readable
inline constexpr double kChartFont = 12.0;
inline constexpr double kTickSpace = 18.0;  // below the frame, for the labels of ticks

struct ChartFrame {
  ChartAxis x, y;
  PixelBox box{};

  // Places of values in the picture; NaN for what an axis cannot show.
  double px(double value) const;
  double py(double value) const;
};

// Width of the widest label of an axis.
double widest_label(const ChartAxis& axis);

// "force / N" in units of 10^-3: "force / 10^-3 N"; what has the unit 1 says none.
std::string axis_label(const std::string& given, int exponent);

// A text whose line stands at y; `anchor` is start, middle or end, `more` further attributes.
std::string chart_text(double x, double y, const char* anchor, const std::string& color,
                       const std::string& text, const std::string& more = "");

// Grid, ticks and their labels of both axes, the frame, and what the axes are.
std::string axes_svg(const ChartFrame& frame, const std::string& x_label,
                     const std::string& y_label, const ChartPaint& paint);

}  // namespace retiarius
