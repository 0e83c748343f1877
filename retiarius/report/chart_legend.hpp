// Where a chart's legend goes: into a free place among the curves, or below them.
#pragma once

#include <optional>
#include <utility>
#include <vector>

namespace retiarius {

using PixelLine = std::vector<std::pair<double, double>>;  // x, y; y downwards

struct PixelBox {
  double left, top, right, bottom;
};

// True when a line passes through the box or a point of it lies there.
bool touches(const PixelLine& line, const PixelBox& box);

// The place of a box of this size inside `frame`, at its corners first and then along its sides,
// that no line touches; none where there is no such place.
std::optional<PixelBox> free_place(const std::vector<PixelLine>& lines, const PixelBox& frame,
                                   double width, double height);

// Places of boxes of these widths in rows of the given width: x and row number.
std::vector<std::pair<double, int>> in_rows(const std::vector<double>& widths, double row_width);

}  // namespace retiarius
