#include "retiarius/report/svg_plot.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "retiarius/report/ticks.hpp"

namespace retiarius {

namespace {

// Units of the viewBox: small, so that text stays readable on a phone.
constexpr double kWidth = 440, kHeight = 230;
constexpr double kLeft = 52, kRight = 430, kTop = 22, kBottom = 196;
constexpr std::size_t kSamples = 400;

std::string unit_text(const Plot& plot, int exponent) {
  const std::string unit = plot.unit == "1" ? "" : escape_html(plot.unit);
  const std::string power = power_of_ten(exponent);
  return power + (power.empty() || unit.empty() ? "" : " ") + unit;
}

std::pair<double, double> range_of(const Plot& plot) {
  double low = INFINITY, high = -INFINITY;
  for (const PlotSeries& series : plot.series)
    for (double y : series.y) {
      if (!std::isfinite(y)) continue;
      low = std::min(low, y);
      high = std::max(high, y);
    }
  if (plot.zero_based && low <= high) {
    low = std::min(low, 0.0);
    high = std::max(high, 0.0);
    if (low == high) high = 1.0;
  }
  return {low, high};
}

int color_of(const Plot& plot, std::size_t number) {
  const int own = plot.series[number].color;
  return (own >= 0 ? own : static_cast<int>(number)) % kPlotColors;
}

struct Mapping {
  Axis x, y;

  double px(double value) const {
    return kLeft + (kRight - kLeft) * (value - x.low) / (x.high - x.low);
  }
  double py(double value) const {
    return kBottom - (kBottom - kTop) * (value - y.low) / (y.high - y.low);
  }
};

std::string axes_svg(const Plot& plot, const Mapping& map) {
  std::string svg;
  const auto out = std::back_inserter(svg);
  for (std::size_t k = 0; k < map.y.ticks.size(); ++k) {
    const double y = map.py(map.y.ticks[k]);
    fmt::format_to(out,
                   "<path class=\"{}\" d=\"M{} {:.1f}H{}\"/>"
                   "<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>",
                   map.y.ticks[k] == 0.0 ? "zero" : "grid", kLeft, y, kRight, kLeft - 6, y + 4,
                   map.y.labels[k]);
  }
  for (std::size_t k = 0; k < map.x.ticks.size(); ++k) {
    const double x = map.px(map.x.ticks[k]);
    fmt::format_to(out,
                   "<path class=\"axis\" d=\"M{0:.1f} {1}v4\"/>"
                   "<text x=\"{0:.1f}\" y=\"{2}\" text-anchor=\"middle\">{3}</text>",
                   x, kBottom, kBottom + 17, map.x.labels[k]);
  }
  for (double mark : plot.marks)
    if (mark > map.x.low && mark < map.x.high)
      fmt::format_to(out, "<path class=\"mark\" d=\"M{:.1f} {}V{}\"/>", map.px(mark), kTop,
                     kBottom);
  fmt::format_to(out, "<path class=\"axis\" d=\"M{} {}H{}\"/>", kLeft, kBottom, kRight);
  fmt::format_to(out, "<text class=\"unit\" x=\"4\" y=\"12\">{}</text>",
                 unit_text(plot, map.y.exponent));
  fmt::format_to(out, "<text class=\"unit\" x=\"{}\" y=\"{}\" text-anchor=\"end\">{}{}</text>",
                 kRight, kHeight - 2, escape_html(plot.x_label),
                 map.x.exponent == 0 ? "" : " \u00b7 " + power_of_ten(-map.x.exponent));
  return svg;
}

std::string line_svg(const Plot& plot, std::size_t number, const Mapping& map) {
  const std::vector<double>& y = plot.series[number].y;
  std::string path, dots;
  bool pen_down = false;
  int points = 0;
  double px = 0.0, py = 0.0;
  const auto finish_run = [&] {  // a single sample between gaps has no line: it is a dot
    if (points == 1)
      dots += fmt::format("<circle class=\"dot s{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\"/>",
                          color_of(plot, number), px, py);
    points = 0;
    pen_down = false;
  };
  for (std::size_t k : thinned(y, kSamples)) {
    if (!std::isfinite(y[k])) {
      finish_run();
      continue;
    }
    px = map.px(plot.x[k]);
    py = map.py(y[k]);
    fmt::format_to(std::back_inserter(path), "{}{:.1f} {:.1f}", pen_down ? 'L' : 'M', px, py);
    pen_down = true;
    ++points;
  }
  finish_run();
  return fmt::format("<path class=\"line s{}\" d=\"{}\"/>", color_of(plot, number), path) + dots;
}

}  // namespace

std::string escape_html(std::string_view text) {
  std::string safe;
  for (char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      case '\'':
        safe += "&#39;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

bool has_data(const Plot& plot) { return range_of(plot).first < INFINITY && !plot.x.empty(); }

std::vector<std::size_t> thinned(const std::vector<double>& y, std::size_t limit) {
  std::vector<std::size_t> kept;
  const std::size_t buckets = std::max<std::size_t>(1, limit / 2);
  if (y.size() <= 2 * buckets) {
    for (std::size_t k = 0; k < y.size(); ++k) kept.push_back(k);
    return kept;
  }
  kept.push_back(0);
  for (std::size_t b = 0; b < buckets; ++b) {
    const std::size_t begin = y.size() * b / buckets, end = y.size() * (b + 1) / buckets;
    std::size_t low = begin, high = begin, gap = end;
    for (std::size_t k = begin; k < end; ++k) {
      if (std::isnan(y[k])) gap = std::min(gap, k);
      if (!(y[low] <= y[k])) low = std::isnan(y[k]) ? low : k;
      if (!(y[high] >= y[k])) high = std::isnan(y[k]) ? high : k;
    }
    std::vector<std::size_t> chosen = {low, high};
    if (gap < end) chosen.push_back(gap);
    std::sort(chosen.begin(), chosen.end());
    for (std::size_t k : chosen)
      if (kept.back() != k) kept.push_back(k);
  }
  if (kept.back() != y.size() - 1) kept.push_back(y.size() - 1);
  return kept;
}

std::string plot_alternative(const Plot& plot) {
  std::string text = plot.title + " over " + plot.x_label + ".";
  const std::string unit = plot.unit.empty() || plot.unit == "1" ? "" : " " + plot.unit;
  for (const PlotSeries& series : plot.series) {
    const auto [low, high] = range_of({{}, {}, {}, {}, {series}, {}, false});
    if (low > high) continue;
    text += fmt::format(" {}: from {:.4g} to {:.4g}{}, last {:.4g}.", series.name, low, high, unit,
                        series.y.back());
  }
  return text;
}

std::string plot_svg(const Plot& plot) {
  const auto [low, high] = range_of(plot);
  const Mapping map{nice_axis(plot.x.front(), plot.x.back(), 6, false),
                    nice_axis(low, high, 5, true)};
  const std::string alternative = escape_html(plot_alternative(plot));
  std::string svg =
      fmt::format("<svg class=\"plot\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">",
                  kWidth, kHeight, alternative);
  svg += axes_svg(plot, map);
  for (std::size_t k = 0; k < plot.series.size(); ++k) svg += line_svg(plot, k, map);
  return svg + "</svg>";
}

std::string legend_html(const Plot& plot) {
  if (plot.series.size() < 2) return "";
  std::string html = "<div class=\"legend\">";
  for (std::size_t k = 0; k < plot.series.size(); ++k)
    html += fmt::format(
        "<span><svg viewBox=\"0 0 22 8\" aria-hidden=\"true\"><path class=\"line s{}\" "
        "d=\"M1 4H21\"/></svg>{}</span>",
        color_of(plot, k), escape_html(plot.series[k].name));
  return html + "</div>";
}

}  // namespace retiarius
