// The curves of a chart, from values to lines and markers on paper.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "retiarius/report/chart.hpp"
#include "retiarius/report/chart_legend.hpp"
#include "retiarius/report/chart_paint.hpp"

namespace retiarius {

// A curve in pixels.
struct DrawnCurve {
  std::string name;
  CurveStyle style = CurveStyle::line;
  std::size_t number = 0;        // among all curves: its colour and its marker
  std::size_t dash_number = 0;   // among the dashed ones
  std::vector<PixelLine> lines;  // runs between gaps; none for points
  PixelLine markers;
  bool hollow = false;
};

// The curve with NaN in both coordinates where one of them cannot be shown. Throws Error where x
// and y differ in length.
Curve visible(const Curve& curve, bool log_x, bool log_y);

// All curves of a chart; `px` and `py` map values to pixels.
std::vector<DrawnCurve> drawn_curves(const Chart& chart, const std::function<double(double)>& px,
                                     const std::function<double(double)>& py);

std::string curve_svg(const DrawnCurve& curve, const ChartPaint& paint);

// The curve's sample in the legend: from x, `width` wide, at height y.
std::string sample_svg(const DrawnCurve& curve, double x, double y, double width,
                       const ChartPaint& paint);

}  // namespace retiarius
