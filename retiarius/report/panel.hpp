// A chart whose content is drawn by whoever makes it: cells of a map, bars, bands, error bars.
#pragma once

#include <string>
#include <vector>

#include "retiarius/report/chart_frame.hpp"

namespace retiarius {

// Drawn with the colours of the page it stands in (page_paint()).
class Panel {
 public:
  // Linear axes over the extents; `loose` moves the ends of the y axis to ticks.
  Panel(const Extent& x, const Extent& y, std::string x_label, std::string y_label,
        bool loose = true, double height = 250.0);
  // Rows instead of a y axis: a bar chart, each row with its name, the first at the top.
  Panel(const Extent& x, std::vector<std::string> rows, std::string x_label);

  const ChartFrame& frame() const { return frame_; }
  double px(double value) const { return frame_.px(value); }
  double py(double value) const { return frame_.py(value); }
  double row_center(std::size_t row) const;
  double row_height() const;

  // Draws in the order of the calls. Coordinates are values; colours are CSS.
  void rectangle(double x0, double y0, double x1, double y1, const std::string& fill,
                 double opacity, const std::string& hint = "");
  void row_bar(std::size_t row, double offset, double thickness, double from, double to,
               const std::string& fill, double opacity = 1.0);
  void row_whisker(std::size_t row, double offset, double low, double high);
  void band(const std::vector<double>& x, const std::vector<double>& low,
            const std::vector<double>& high, const std::string& fill, double opacity);
  void line(const std::vector<double>& x, const std::vector<double>& y, const std::string& color,
            const std::string& dashing = "");
  void whisker(double x, double low, double high, const std::string& color);
  // The n-th shape of marker_svg().
  void marker(std::size_t n, double x, double y, double size, const std::string& color, bool filled,
              double opacity = 1.0);
  void text(double x, double y, const std::string& content, double size, const std::string& color,
            double shift = 0.0);  // `shift`: px downwards
  // Names beside samples, below the axes. Shape -1: a filled square.
  void legend(const std::string& name, int shape, const std::string& color, double opacity = 1.0);

  // The picture; `id` makes its ids unique within a page, `alternative` says in words what it
  // shows.
  std::string svg(const std::string& title, const std::string& alternative,
                  const std::string& id) const;

 private:
  struct Entry {
    std::string name, sample;
  };
  std::string rows_svg() const;

  ChartFrame frame_;
  std::string x_label_, y_label_;
  std::vector<std::string> rows_;
  std::string body_;
  std::vector<Entry> legend_;
};

}  // namespace retiarius
