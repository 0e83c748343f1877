#include "retiarius/report/panel.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "retiarius/report/svg_plot.hpp"

namespace retiarius {

namespace {

constexpr double kRightMargin = 16.0, kTop = 10.0, kRow = 34.0, kLegendLine = 17.0;
constexpr double kLegendFont = 11.5;

// An extent of no length gives an axis that shows its value in the middle.
Extent widened(Extent e) {
  if (e.empty() || e.high > e.low) return e;
  const double half = e.low == 0.0 ? 1.0 : 0.1 * std::abs(e.low);
  return {e.low - half, e.high + half};
}

std::string path_of(const std::vector<std::pair<double, double>>& points) {
  std::string d;
  bool pen_down = false;
  for (const auto& [x, y] : points) {
    const bool there = std::isfinite(x) && std::isfinite(y);
    if (there) fmt::format_to(std::back_inserter(d), "{}{:.1f} {:.1f}", pen_down ? 'L' : 'M', x, y);
    pen_down = there;
  }
  return d;
}

}  // namespace

Panel::Panel(const Extent& x, const Extent& y, std::string x_label, std::string y_label, bool loose,
             double height)
    : x_label_(std::move(x_label)), y_label_(std::move(y_label)) {
  frame_.x = linear_axis(widened(x), 6, false);
  frame_.y = linear_axis(widened(y), 5, loose);
  frame_.box = {28.0 + widest_label(frame_.y), kTop, kChartWidth - kRightMargin, kTop + height};
}

Panel::Panel(const Extent& x, std::vector<std::string> rows, std::string x_label)
    : x_label_(std::move(x_label)), rows_(std::move(rows)) {
  frame_.x = linear_axis(widened(x), 6, false);
  frame_.y = {false, 0.0, 1.0, {}, {}, {}, 0};
  double widest = 0.0;
  for (const std::string& row : rows_) widest = std::max(widest, text_width(row, kChartFont));
  frame_.box = {std::min(12.0 + widest, 0.45 * kChartWidth), kTop, kChartWidth - kRightMargin,
                kTop + kRow * static_cast<double>(rows_.size())};
}

double Panel::row_center(std::size_t row) const {
  return frame_.box.top + kRow * (static_cast<double>(row) + 0.5);
}
double Panel::row_height() const { return kRow; }

void Panel::rectangle(double x0, double y0, double x1, double y1, const std::string& fill,
                      double opacity, const std::string& hint) {
  const double left = px(x0), right = px(x1), top = py(y1), bottom = py(y0);
  body_ += fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" "
      "style=\"fill:{};fill-opacity:{:.2f}\"",
      left, top, std::max(0.0, right - left), std::max(0.0, bottom - top), fill, opacity);
  body_ += hint.empty() ? "/>" : fmt::format("><title>{}</title></rect>", escape_html(hint));
}

void Panel::row_bar(std::size_t row, double offset, double thickness, double from, double to,
                    const std::string& fill, double opacity) {
  const double left = px(std::min(from, to)), right = px(std::max(from, to));
  if (!std::isfinite(left) || !std::isfinite(right)) return;
  body_ += fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" "
      "style=\"fill:{};fill-opacity:{:.2f}\"/>",
      left, row_center(row) + offset - 0.5 * thickness, right - left, thickness, fill, opacity);
}

void Panel::row_whisker(std::size_t row, double offset, double low, double high) {
  if (!std::isfinite(low) || !std::isfinite(high)) return;
  const double y = row_center(row) + offset;
  body_ += fmt::format(
      "<path style=\"stroke:{};fill:none;stroke-width:1.3\" d=\"M{:.1f} {:.1f}H{:.1f}M{:.1f} "
      "{:.1f}v6M{:.1f} {:.1f}v6\"/>",
      page_paint().ink, px(low), y, px(high), px(low), y - 3.0, px(high), y - 3.0);
}

void Panel::band(const std::vector<double>& x, const std::vector<double>& low,
                 const std::vector<double>& high, const std::string& fill, double opacity) {
  std::vector<std::pair<double, double>> outline;
  for (std::size_t k = 0; k < x.size(); ++k) outline.emplace_back(px(x[k]), py(high[k]));
  for (std::size_t k = x.size(); k-- > 0;) outline.emplace_back(px(x[k]), py(low[k]));
  body_ += fmt::format("<path style=\"fill:{};fill-opacity:{:.2f};stroke:none\" d=\"{}z\"/>", fill,
                       opacity, path_of(outline));
}

void Panel::line(const std::vector<double>& x, const std::vector<double>& y,
                 const std::string& color, const std::string& dashing) {
  std::vector<std::pair<double, double>> points;
  for (std::size_t k = 0; k < x.size(); ++k) points.emplace_back(px(x[k]), py(y[k]));
  body_ += fmt::format(
      "<path style=\"stroke:{};fill:none;stroke-width:1.7;stroke-linejoin:round{}\" d=\"{}\"/>",
      color, dashing.empty() ? "" : ";stroke-dasharray:" + dashing, path_of(points));
}

void Panel::whisker(double x, double low, double high, const std::string& color) {
  if (!std::isfinite(px(x)) || !std::isfinite(py(low)) || !std::isfinite(py(high))) return;
  body_ += fmt::format(
      "<path style=\"stroke:{};fill:none;stroke-width:1.3\" d=\"M{:.1f} {:.1f}V{:.1f}M{:.1f} "
      "{:.1f}h6M{:.1f} {:.1f}h6\"/>",
      color, px(x), py(low), py(high), px(x) - 3.0, py(low), px(x) - 3.0, py(high));
}

void Panel::marker(std::size_t n, double x, double y, double size, const std::string& color,
                   bool filled, double opacity) {
  if (!std::isfinite(px(x)) || !std::isfinite(py(y))) return;
  body_ += fmt::format("<g stroke-width=\"1.2\" opacity=\"{:.2f}\">{}</g>", opacity,
                       marker_svg(n, px(x), py(y), size, color, filled ? color : "none"));
}

void Panel::text(double x, double y, const std::string& content, double size,
                 const std::string& color, double shift) {
  body_ += chart_text(px(x), py(y) + shift, "middle", color, content,
                      fmt::format(" font-size=\"{}\"", size));
}

void Panel::legend(const std::string& name, int shape, const std::string& color, double opacity) {
  const std::string sample = shape < 0 ? fmt::format(
                                             "<rect x=\"-5\" y=\"-5\" width=\"10\" height=\"10\" "
                                             "style=\"fill:{};fill-opacity:{:.2f};stroke:{}\"/>",
                                             color, opacity, page_paint().soft)
                                       : "<g stroke-width=\"1.2\">" +
                                             marker_svg(static_cast<std::size_t>(shape), 0, 0, 3.5,
                                                        color, shape == 0 ? color : "none") +
                                             "</g>";
  legend_.push_back({name, sample});
}

// Names and separating lines of a bar chart's rows, the grid of its axis, and its zero.
std::string Panel::rows_svg() const {
  const ChartPaint& paint = page_paint();
  const PixelBox& box = frame_.box;
  std::string svg;
  for (std::size_t k = 0; k < rows_.size(); ++k)
    svg += chart_text(box.left - 8.0, row_center(k) + 4.0, "end", paint.ink, rows_[k]);
  if (frame_.x.low < 0.0 && frame_.x.high > 0.0)
    svg += fmt::format("<path style=\"stroke:{}\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>", paint.ink,
                       px(0.0), box.top, box.bottom);
  return svg;
}

std::string Panel::svg(const std::string& title, const std::string& alternative,
                       const std::string& id) const {
  const ChartPaint& paint = page_paint();
  const PixelBox& box = frame_.box;
  std::vector<double> widths;
  for (const Entry& entry : legend_) widths.push_back(34.0 + text_width(entry.name, kLegendFont));
  const auto places = in_rows(widths, kChartWidth - 20.0);
  const double bottom = box.bottom + kTickSpace + 24.0;
  const double legend =
      places.empty() ? 0.0 : kLegendLine * static_cast<double>(places.back().second + 1) + 4.0;
  std::string text = fmt::format(
      "<svg class=\"chart\" viewBox=\"0 0 {0:.0f} {1:.0f}\" font-size=\"{2}\" role=\"img\" "
      "aria-labelledby=\"{3}-t {3}-d\"><title id=\"{3}-t\">{4}</title><desc "
      "id=\"{3}-d\">{5}</desc>",
      kChartWidth, bottom + legend, kChartFont, escape_html(id), escape_html(title),
      escape_html(alternative));
  text += axes_svg(frame_, x_label_, y_label_, paint) + body_;
  if (!rows_.empty()) text += rows_svg();
  for (std::size_t k = 0; k < legend_.size(); ++k) {
    const double x = 20.0 + places[k].first, y = bottom + 10.0 + kLegendLine * places[k].second;
    text += fmt::format("<g transform=\"translate({:.1f} {:.1f})\">{}</g>", x, y - 4.0,
                        legend_[k].sample) +
            chart_text(x + 12.0, y, "start", paint.ink, legend_[k].name,
                       fmt::format(" font-size=\"{}\"", kLegendFont));
  }
  return text + "</svg>";
}

}  // namespace retiarius
