#include "retiarius/report/chart_svg.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "retiarius/report/chart_curves.hpp"
#include "retiarius/report/chart_frame.hpp"
#include "retiarius/report/chart_legend.hpp"
#include "retiarius/report/chart_paint.hpp"
#include "retiarius/report/svg_plot.hpp"

namespace retiarius {

namespace {

// Units of the viewBox: small, so that text stays readable on a phone.
constexpr double kWidth = kChartWidth, kFont = kChartFont, kLegendFont = 11.5, kTitleFont = 13.5;
constexpr double kPlotHeight = 250.0, kLeastHeight = 120.0, kMostHeight = 400.0;
constexpr double kRightMargin = 16.0, kLabelSpace = 20.0;
constexpr double kSample = 26.0, kLegendLine = 17.0;  // a line's sample, a row of the legend
constexpr const char* kFontFamily =
    "system-ui,-apple-system,'Segoe UI',Roboto,'Helvetica Neue','DejaVu Sans',Arial,sans-serif";

;

Extent widened(Extent extent, double length) {
  const double middle = 0.5 * (extent.low + extent.high);
  return {middle - 0.5 * length, middle + 0.5 * length};
}

// One unit of x as long as one of y: the frame's height follows the data as far as it can, then
// the shorter range is widened.
void make_equal(ChartFrame& layout, Extent x, Extent y) {
  const double width = layout.box.right - layout.box.left;
  const double margin = 0.04 * std::max({x.high - x.low, y.high - y.low, 1e-300});
  x = widened(x, x.high - x.low + 2 * margin);
  y = widened(y, y.high - y.low + 2 * margin);
  const double height =
      std::clamp(width * (y.high - y.low) / (x.high - x.low), kLeastHeight, kMostHeight);
  const double scale = std::max((x.high - x.low) / width, (y.high - y.low) / height);
  layout.x = linear_axis(widened(x, scale * width), 6, false);
  layout.y = linear_axis(widened(y, scale * height), static_cast<int>(2 + height / 60), false);
  layout.box.bottom = layout.box.top + height;
}

ChartFrame layout_of(const Chart& chart, double top) {
  Extent x = Extent::none(), y = Extent::none();
  for (const Curve& curve : chart.curves) {
    const Curve shown = visible(curve, chart.log_x, chart.log_y);
    x.add(shown.x, chart.log_x);
    y.add(shown.y, chart.log_y);
  }
  ChartFrame layout;
  layout.x = chart.log_x ? log_axis(x) : linear_axis(x, 6, false);
  layout.y = chart.log_y ? log_axis(y) : linear_axis(y, 5, true);
  const bool equal = chart.equal_axes && !x.empty() && !chart.log_x && !chart.log_y;
  layout.box = {0.0, top, kWidth - kRightMargin, top + kPlotHeight};
  for (int pass = 0; pass < 2; ++pass) {  // the labels' width depends on the range, and back
    layout.box.left = kLabelSpace + widest_label(layout.y) + 8.0;
    if (equal) make_equal(layout, x, y);
  }
  return layout;
}

std::string entry_svg(const DrawnCurve& curve, double x, double y, const ChartPaint& paint) {
  return sample_svg(curve, x, y - 4.0, kSample - 6.0, paint) +
         chart_text(x + kSample, y, "start", paint.ink, curve.name,
                    fmt::format(" font-size=\"{}\"", kLegendFont));
}

// The legend, and how much it needs below the frame.
struct Legend {
  std::string svg;
  double height = 0.0;
};

Legend legend_of(const std::vector<DrawnCurve>& curves, const PixelBox& frame,
                 const ChartPaint& paint) {
  std::vector<const DrawnCurve*> named;
  std::vector<double> widths;
  std::vector<PixelLine> lines;
  for (const DrawnCurve& curve : curves) {
    lines.insert(lines.end(), curve.lines.begin(), curve.lines.end());
    for (const auto& marker : curve.markers) lines.push_back({marker});
    if (curve.name.empty()) continue;
    named.push_back(&curve);
    widths.push_back(kSample + text_width(curve.name, kLegendFont) + 14.0);
  }
  Legend legend;
  if (named.empty()) return legend;
  const double width = *std::max_element(widths.begin(), widths.end()) - 4.0;
  const double height = kLegendLine * static_cast<double>(named.size()) + 5.0;
  if (const auto box = free_place(lines, frame, width, height)) {
    legend.svg = fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" rx=\"3\" "
        "style=\"fill:{};stroke:{}\"/>",
        box->left, box->top, width, height, paint.paper, paint.grid);
    for (std::size_t k = 0; k < named.size(); ++k)
      legend.svg += entry_svg(*named[k], box->left + 6.0,
                              box->top + 15.0 + kLegendLine * static_cast<double>(k), paint);
    return legend;
  }
  const auto places = in_rows(widths, kWidth - 20.0);
  for (std::size_t k = 0; k < named.size(); ++k)
    legend.svg +=
        entry_svg(*named[k], 14.0 + places[k].first,
                  frame.bottom + kTickSpace + 36.0 + kLegendLine * places[k].second, paint);
  legend.height = kLegendLine * (places.back().second + 1) + 4.0;
  return legend;
}

std::string range_text(const Extent& extent) {
  return fmt::format("from {:.4g} to {:.4g}", extent.low, extent.high);
}

// "<svg ...>" with title and description, and the paper that a file of its own needs.
std::string opening(const Chart& chart, ChartLook look, const std::string& id, double height,
                    const ChartPaint& paint) {
  std::string svg = "<svg ";
  if (look == ChartLook::standalone)
    svg += fmt::format(
        "xmlns=\"http://www.w3.org/2000/svg\" width=\"{:.0f}\" height=\"{:.0f}\" "
        "font-family=\"{}\" ",
        1.5 * kWidth, 1.5 * height, kFontFamily);
  svg += fmt::format(
      "class=\"chart\" viewBox=\"0 0 {0:.0f} {1:.0f}\" font-size=\"{2}\" role=\"img\" "
      "aria-labelledby=\"{3}-t {3}-d\"><title id=\"{3}-t\">{4}</title><desc "
      "id=\"{3}-d\">{5}</desc>",
      kWidth, height, kFont, escape_html(id), escape_html(chart.title),
      escape_html(chart_alternative(chart)));
  if (look == ChartLook::standalone)
    svg += fmt::format("<rect width=\"100%\" height=\"100%\" style=\"fill:{}\"/>", paint.paper) +
           chart_text(kWidth / 2, 19.0, "middle", paint.ink, chart.title,
                      fmt::format(" font-size=\"{}\" font-weight=\"600\"", kTitleFont));
  return svg;
}

}  // namespace

std::string chart_alternative(const Chart& chart) {
  std::string text = fmt::format("{} over {}.", chart.y_label, chart.x_label);
  for (const Curve& curve : chart.curves) {
    const Curve shown = visible(curve, chart.log_x, chart.log_y);
    Extent x = Extent::none(), y = Extent::none();
    x.add(shown.x, chart.log_x);
    y.add(shown.y, chart.log_y);
    text += curve.name.empty() ? " Curve: " : fmt::format(" {}: ", curve.name);
    if (y.empty())
      text += "no values.";
    else
      text += fmt::format("{} for abscissae {}.", range_text(y), range_text(x));
  }
  if (!chart.caption.empty()) text += " " + chart.caption;
  if (!chart.source.empty()) text += " Source: " + chart.source + ".";
  return text;
}

std::string chart_svg(const Chart& chart, ChartLook look, const std::string& id) {
  const bool alone = look == ChartLook::standalone;
  const ChartPaint& paint = alone ? print_paint() : page_paint();
  const ChartFrame layout = layout_of(chart, alone ? 32.0 : 10.0);
  const PixelBox& frame = layout.box;
  const std::vector<DrawnCurve> curves = drawn_curves(
      chart, [&](double x) { return layout.px(x); }, [&](double y) { return layout.py(y); });
  const Legend legend = legend_of(curves, frame, paint);
  const double height = frame.bottom + kTickSpace + 24.0 + legend.height;
  std::string svg = opening(chart, look, id, height, paint) +
                    axes_svg(layout, chart.x_label, chart.y_label, paint);
  // Lines below, what they are compared with above, so that both are seen.
  for (CurveStyle style : {CurveStyle::line, CurveStyle::dashed, CurveStyle::points})
    for (const DrawnCurve& curve : curves)
      if (curve.style == style) svg += curve_svg(curve, paint);
  return svg + legend.svg + "</svg>" + (alone ? "\n" : "");
}

}  // namespace retiarius
