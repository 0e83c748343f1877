#include "retiarius/report/chart_legend.hpp"

#include <algorithm>

namespace retiarius {

namespace {

constexpr double kMargin = 9.0;     // of a legend from the frame
constexpr double kClearance = 5.0;  // of curves from a legend

// Whether the straight piece from a to b meets the box (Liang and Barsky's clipping).
bool meets(std::pair<double, double> a, std::pair<double, double> b, const PixelBox& box) {
  const double dx = b.first - a.first, dy = b.second - a.second;
  double from = 0.0, to = 1.0;
  const auto clip = [&](double direction, double distance) {
    if (direction == 0.0) return distance >= 0.0;
    const double t = distance / direction;
    if (direction < 0.0)
      from = std::max(from, t);
    else
      to = std::min(to, t);
    return from <= to;
  };
  return clip(-dx, a.first - box.left) && clip(dx, box.right - a.first) &&
         clip(-dy, a.second - box.top) && clip(dy, box.bottom - a.second);
}

}  // namespace

bool touches(const PixelLine& line, const PixelBox& box) {
  if (line.size() == 1) return meets(line[0], line[0], box);
  for (std::size_t k = 1; k < line.size(); ++k)
    if (meets(line[k - 1], line[k], box)) return true;
  return false;
}

std::optional<PixelBox> free_place(const std::vector<PixelLine>& lines, const PixelBox& frame,
                                   double width, double height) {
  const double left = frame.left + kMargin, right = frame.right - kMargin - width;
  const double top = frame.top + kMargin, bottom = frame.bottom - kMargin - height;
  if (right < left || bottom < top) return {};
  const double middle = 0.5 * (left + right), half = 0.5 * (top + bottom);
  const std::pair<double, double> places[] = {{right, top},   {left, top},     {right, bottom},
                                              {left, bottom}, {right, half},   {left, half},
                                              {middle, top},  {middle, bottom}};
  for (const auto& [x, y] : places) {
    const PixelBox box{x - kClearance, y - kClearance, x + width + kClearance,
                       y + height + kClearance};
    if (std::none_of(lines.begin(), lines.end(),
                     [&](const PixelLine& line) { return touches(line, box); }))
      return PixelBox{x, y, x + width, y + height};
  }
  return {};
}

std::vector<std::pair<double, int>> in_rows(const std::vector<double>& widths, double row_width) {
  std::vector<std::pair<double, int>> places;
  double x = 0.0;
  int row = 0;
  for (double width : widths) {
    if (x > 0.0 && x + width > row_width) {
      x = 0.0;
      ++row;
    }
    places.emplace_back(x, row);
    x += width;
  }
  return places;
}

}  // namespace retiarius
