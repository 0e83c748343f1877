// Colours, dashes and markers of charts. The colours are those of Okabe and Ito, which colour-blind
// readers tell apart; dashes and markers tell curves apart without colour.
#pragma once

#include <string>

namespace retiarius {

// CSS colours by purpose.
struct ChartPaint {
  std::string ink, soft, grid, paper;
  std::string series[7];
};

// Variables of the page that holds the chart (--ink, --soft, --grid, --card, --c0 ... --c6), with
// light colours where it has none.
const ChartPaint& page_paint();
// Light colours, for print and for pictures that stand alone.
const ChartPaint& print_paint();

const std::string& color_of(const ChartPaint& paint, std::size_t curve);

// stroke-dasharray of the n-th dashed curve.
const char* dashes(std::size_t n);

// A marker centred at (x, y), hollow, in the n-th of seven shapes. `size`: half its width.
std::string marker_svg(std::size_t n, double x, double y, double size, const std::string& stroke,
                       const std::string& fill);

// The digit, raised.
const char* superscript(char digit);

// About how wide the text is at a font size, in the same unit; never too small for common fonts.
double text_width(const std::string& text, double font_size);

}  // namespace retiarius
