#include "retiarius/report/chart_curves.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/report/svg_plot.hpp"

namespace retiarius {

namespace {

constexpr std::size_t kSamples = 400;  // of a line
constexpr std::size_t kMarkers = 60;   // of points
constexpr std::size_t kFew = 14;       // a line of so few samples shows each of them
constexpr double kMarkerSize = 4.0, kSparseSize = 2.6;

// Samples that hold the extremes of both coordinates.
std::vector<std::size_t> kept_samples(const Curve& curve, std::size_t limit) {
  std::vector<std::size_t> kept = thinned(curve.y, limit);
  if (curve.y.size() <= limit || std::is_sorted(curve.x.begin(), curve.x.end())) return kept;
  const std::vector<std::size_t> other = thinned(curve.x, limit);
  std::vector<std::size_t> both;
  std::set_union(kept.begin(), kept.end(), other.begin(), other.end(), std::back_inserter(both));
  return both;
}

std::vector<PixelLine> runs(const PixelLine& points) {
  std::vector<PixelLine> lines(1);
  for (const auto& p : points) {
    if (std::isfinite(p.first))
      lines.back().push_back(p);
    else if (!lines.back().empty())
      lines.emplace_back();
  }
  if (lines.back().empty()) lines.pop_back();
  return lines;
}

// A handful of markers along a line, evenly by its length, those of each curve at places of their
// own.
PixelLine sparse_markers(const std::vector<PixelLine>& lines, std::size_t number,
                         std::size_t curves) {
  constexpr int count = 4;
  double length = 0.0;
  const auto piece = [](const auto& a, const auto& b) {
    return std::abs(b.first - a.first);  // along the axis: oscillations would take most of them
  };
  for (const PixelLine& line : lines)
    for (std::size_t k = 1; k < line.size(); ++k) length += piece(line[k - 1], line[k]);
  const double spacing = length / count;
  double next = spacing * (static_cast<double>(number) + 0.5) / static_cast<double>(curves);
  double done = 0.0;
  PixelLine markers;
  for (const PixelLine& line : lines)
    for (std::size_t k = 1; k < line.size(); ++k) {
      done += piece(line[k - 1], line[k]);
      if (done < next || spacing == 0.0) continue;
      markers.push_back(line[k]);
      next += spacing;
    }
  return markers;
}

std::string path_of(const std::vector<PixelLine>& lines) {
  std::string path;
  for (const PixelLine& line : lines)
    for (std::size_t k = 0; k < line.size(); ++k)
      fmt::format_to(std::back_inserter(path), "{}{:.1f} {:.1f}", k == 0 ? 'M' : 'L', line[k].first,
                     line[k].second);
  return path;
}

std::string line_svg(const DrawnCurve& curve, const std::string& d, const ChartPaint& paint) {
  const std::string dashing = curve.style == CurveStyle::dashed
                                  ? fmt::format(";stroke-dasharray:{}", dashes(curve.dash_number))
                                  : "";
  return fmt::format(
      "<path style=\"stroke:{};fill:none;stroke-width:1.7;stroke-linejoin:round{}\" d=\"{}\"/>",
      color_of(paint, curve.number), dashing, d);
}

std::string one_marker(const DrawnCurve& curve, double x, double y, const ChartPaint& paint) {
  const std::string& color = color_of(paint, curve.number);
  return marker_svg(curve.number, x, y, curve.hollow ? kMarkerSize : kSparseSize, color,
                    curve.hollow ? "none" : color);
}

DrawnCurve drawn(const Curve& given, bool log_x, bool log_y,
                 const std::function<double(double)>& px, const std::function<double(double)>& py) {
  const Curve curve = visible(given, log_x, log_y);
  const bool points = curve.style == CurveStyle::points;
  PixelLine pixels;
  for (std::size_t k : kept_samples(curve, points ? kMarkers : kSamples))
    pixels.emplace_back(px(curve.x[k]), py(curve.y[k]));
  DrawnCurve result;
  result.name = curve.name;
  result.style = curve.style;
  result.hollow = points;
  const std::vector<PixelLine> lines = runs(pixels);
  if (!points) result.lines = lines;
  const auto add_all = [&](const PixelLine& line) {
    result.markers.insert(result.markers.end(), line.begin(), line.end());
  };
  const bool few = curve.style == CurveStyle::line && pixels.size() <= kFew;
  for (const PixelLine& line : lines)
    if (points || few || line.size() == 1) add_all(line);
  return result;
}

}  // namespace

Curve visible(const Curve& curve, bool log_x, bool log_y) {
  if (curve.x.size() != curve.y.size())
    throw Error(fmt::format("the curve {} has {} abscissae and {} ordinates", curve.name,
                            curve.x.size(), curve.y.size()));
  Curve result = curve;
  const auto shown = [](double v, bool log) { return std::isfinite(v) && (!log || v > 0.0); };
  for (std::size_t k = 0; k < curve.x.size(); ++k)
    if (!shown(curve.x[k], log_x) || !shown(curve.y[k], log_y)) result.x[k] = result.y[k] = NAN;
  return result;
}

std::vector<DrawnCurve> drawn_curves(const Chart& chart, const std::function<double(double)>& px,
                                     const std::function<double(double)>& py) {
  std::vector<DrawnCurve> curves;
  std::size_t dashed = 0, solid = 0;
  for (const Curve& curve : chart.curves) {
    curves.push_back(drawn(curve, chart.log_x, chart.log_y, px, py));
    curves.back().number = curves.size() - 1;
    if (curve.style == CurveStyle::dashed) curves.back().dash_number = dashed++;
    if (curve.style == CurveStyle::line) ++solid;
  }
  // A single line needs no marker to be told apart.
  for (DrawnCurve& curve : curves)
    if (solid > 1 && curve.style == CurveStyle::line && curve.markers.empty())
      curve.markers = sparse_markers(curve.lines, curve.number, curves.size());
  return curves;
}

std::string curve_svg(const DrawnCurve& curve, const ChartPaint& paint) {
  std::string svg;
  if (!curve.lines.empty()) svg += line_svg(curve, path_of(curve.lines), paint);
  if (curve.markers.empty()) return svg;
  svg += "<g stroke-width=\"1.3\">";
  for (const auto& [x, y] : curve.markers) svg += one_marker(curve, x, y, paint);
  return svg + "</g>";
}

std::string sample_svg(const DrawnCurve& curve, double x, double y, double width,
                       const ChartPaint& paint) {
  std::string svg;
  if (curve.style != CurveStyle::points)
    svg += line_svg(curve, fmt::format("M{:.1f} {:.1f}h{:.1f}", x, y, width), paint);
  if (!curve.markers.empty())
    svg += "<g stroke-width=\"1.3\">" + one_marker(curve, x + 0.5 * width, y, paint) + "</g>";
  return svg;
}

}  // namespace retiarius
