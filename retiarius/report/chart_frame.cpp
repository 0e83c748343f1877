#include "retiarius/report/chart_frame.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "retiarius/report/svg_plot.hpp"
#include "retiarius/report/ticks.hpp"

namespace retiarius {

namespace {

// "L^3" and the unit "m2" with superscripts.
std::string with_superscripts(const std::string& label) {
  const std::size_t slash = label.rfind(" / ");
  const std::size_t unit = slash == std::string::npos ? label.size() : slash;
  std::string text;
  for (std::size_t k = 0; k < label.size(); ++k) {
    const bool power = label[k] == '^' && k + 1 < label.size() && std::isdigit(label[k + 1]) != 0;
    if (power) ++k;
    if (power ||
        (k > unit + 3 && (label[k] == '2' || label[k] == '3') && std::isalpha(label[k - 1]) != 0))
      text += superscript(label[k]);
    else
      text += label[k];
  }
  return text;
}

}  // namespace

double ChartFrame::px(double value) const {
  return box.left + (box.right - box.left) * x.fraction(value);
}
double ChartFrame::py(double value) const {
  return box.bottom - (box.bottom - box.top) * y.fraction(value);
}

double widest_label(const ChartAxis& axis) {
  double width = 0.0;
  for (const std::string& label : axis.labels)
    width = std::max(width, text_width(label, kChartFont));
  return width;
}

std::string axis_label(const std::string& given, int exponent) {
  std::string label = with_superscripts(given);
  if (label.ends_with(" / 1")) label.resize(label.size() - 4);
  if (exponent == 0) return label;
  const std::string power = power_of_ten(exponent);
  const std::size_t slash = given.ends_with(" / 1") ? std::string::npos : label.rfind(" / ");
  if (slash == std::string::npos) return label + " / " + power;
  return label.substr(0, slash) + " / " + power + " " + label.substr(slash + 3);
}

std::string chart_text(double x, double y, const char* anchor, const std::string& color,
                       const std::string& text, const std::string& more) {
  return fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" style=\"fill:{}\"{}>{}</text>", x, y,
      anchor, color, more, escape_html(text));
}

std::string axes_svg(const ChartFrame& frame, const std::string& x_label,
                     const std::string& y_label, const ChartPaint& paint) {
  const PixelBox& f = frame.box;
  std::string grid, ticks, texts;
  for (std::size_t k = 0; k < frame.x.ticks.size(); ++k) {
    const double x = frame.px(frame.x.ticks[k]);
    grid += fmt::format("M{:.1f} {:.1f}V{:.1f}", x, f.top, f.bottom);
    ticks += fmt::format("M{:.1f} {:.1f}v-6", x, f.bottom);
    // A label at the end of the axis stays within the picture.
    const double half = 0.5 * text_width(frame.x.labels[k], kChartFont);
    texts += chart_text(std::min(x, kChartWidth - 1.0 - half), f.bottom + 15.0, "middle",
                        paint.soft, frame.x.labels[k]);
  }
  for (double v : frame.x.minor) ticks += fmt::format("M{:.1f} {:.1f}v-3", frame.px(v), f.bottom);
  for (std::size_t k = 0; k < frame.y.ticks.size(); ++k) {
    const double y = frame.py(frame.y.ticks[k]);
    grid += fmt::format("M{:.1f} {:.1f}H{:.1f}", f.left, y, f.right);
    ticks += fmt::format("M{:.1f} {:.1f}h6", f.left, y);
    texts += chart_text(f.left - 6.0, y + 4.0, "end", paint.soft, frame.y.labels[k]);
  }
  for (double v : frame.y.minor) ticks += fmt::format("M{:.1f} {:.1f}h3", f.left, frame.py(v));
  texts += chart_text(0.5 * (f.left + f.right), f.bottom + kTickSpace + 15.0, "middle", paint.ink,
                      axis_label(x_label, frame.x.exponent));
  const double middle = 0.5 * (f.top + f.bottom);
  texts += chart_text(13.0, middle, "middle", paint.ink, axis_label(y_label, frame.y.exponent),
                      fmt::format(" transform=\"rotate(-90 13 {:.1f})\"", middle));
  return fmt::format(
      "<path style=\"stroke:{};fill:none\" d=\"{}\"/>"
      "<path style=\"stroke:{};fill:none\" d=\"{}M{:.1f} {:.1f}H{:.1f}V{:.1f}H{:.1f}z\"/>{}",
      paint.grid, grid, paint.soft, ticks, f.left, f.top, f.right, f.bottom, f.left, texts);
}

}  // namespace retiarius
