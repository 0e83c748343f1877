#include "retiarius/report/chart_paint.hpp"

#include <string_view>

#include <fmt/format.h>

namespace retiarius {

const ChartPaint& print_paint() {
  static const ChartPaint paint = {
      "#1b2330",
      "#46505d",
      "#e3e7ec",
      "#ffffff",
      {"#0072b2", "#d55e00", "#009e73", "#b0578d", "#a87500", "#3a96cf", "#1b2330"}};
  return paint;
}

const ChartPaint& page_paint() {
  static const ChartPaint paint = [] {
    const ChartPaint& light = print_paint();
    const auto variable = [](const char* name, const std::string& fallback) {
      return fmt::format("var(--{},{})", name, fallback);
    };
    ChartPaint p{variable("ink", light.ink),
                 variable("soft", light.soft),
                 variable("grid", light.grid),
                 variable("card", light.paper),
                 {}};
    for (std::size_t k = 0; k < std::size(p.series); ++k)
      p.series[k] = variable(fmt::format("c{}", k).c_str(), light.series[k]);
    return p;
  }();
  return paint;
}

const std::string& color_of(const ChartPaint& paint, std::size_t curve) {
  // The sixth and the seventh change places: ink stands out from the blue of the first curve.
  constexpr std::size_t order[] = {0, 1, 2, 3, 4, 6, 5};
  return paint.series[order[curve % std::size(order)]];
}

const char* dashes(std::size_t n) {
  constexpr const char* patterns[] = {"6 3", "2 2.5", "9 3 2 3", "4 2 4", "10 3 2 3 2 3", "1.5 4"};
  return patterns[n % std::size(patterns)];
}

std::string marker_svg(std::size_t n, double x, double y, double size, const std::string& stroke,
                       const std::string& fill) {
  const std::string style =
      fmt::format("style=\"stroke:{};fill:{}\"", stroke, n % 7 < 5 ? fill : "none");
  const double s = size;
  const auto path = [&](const std::string& d) {
    return fmt::format("<path {} d=\"M{:.1f} {:.1f}{}\"/>", style, x, y, d);
  };
  switch (n % 7) {
    case 0:
      return fmt::format("<circle {} cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>", style, x, y, s);
    case 1:
      return path(fmt::format("m{0:.1f} {0:.1f}h{1:.1f}v{1:.1f}h{2:.1f}z", -s, 2 * s, -2 * s));
    case 2:
      return path(
          fmt::format("m0 {:.1f}l{:.1f} {:.1f}h{:.1f}z", -1.2 * s, 1.1 * s, 2 * s, -2.2 * s));
    case 3:
      return path(fmt::format("m0 {0:.1f}l{1:.1f} {1:.1f} {2:.1f} {1:.1f} {2:.1f} {2:.1f}z",
                              -1.3 * s, 1.3 * s, -1.3 * s));
    case 4:
      return path(
          fmt::format("m0 {:.1f}l{:.1f} {:.1f}h{:.1f}z", 1.2 * s, 1.1 * s, -2 * s, -2.2 * s));
    case 5:
      return path(fmt::format("m{0:.1f} 0h{1:.1f}m{0:.1f} {0:.1f}v{1:.1f}", -1.2 * s, 2.4 * s));
    default:
      return path(fmt::format("m{0:.1f} {0:.1f}l{1:.1f} {1:.1f}m0 {2:.1f}l{2:.1f} {1:.1f}", -s,
                              2 * s, -2 * s));
  }
}

const char* superscript(char digit) {
  constexpr const char* raised[] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                    "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
  return raised[digit - '0'];
}

double text_width(const std::string& text, double font_size) {
  constexpr std::string_view narrow = " .,:;'|!()[]/iljtfrI-";
  constexpr std::string_view wide = "mwMWQOGD@%";
  double width = 0.0;
  for (char c : text) {
    if ((static_cast<unsigned char>(c) & 0xC0) == 0x80) continue;  // inside a UTF-8 character
    if (narrow.find(c) != std::string_view::npos)
      width += 0.38;
    else if (wide.find(c) != std::string_view::npos)
      width += 0.96;
    else
      width += 0.645;
  }
  return width * font_size;
}

}  // namespace retiarius
