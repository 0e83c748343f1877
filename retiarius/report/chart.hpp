// A chart for print and page: curves with abscissae of their own, linear or logarithmic axes.
#pragma once

#include <string>
#include <vector>

namespace retiarius {

enum class CurveStyle { line, dashed, points };

struct Curve {
  std::string name;
  std::vector<double> x, y;  // of the same length; NaN leaves a gap
  CurveStyle style = CurveStyle::line;
};

struct Chart {
  std::string title;
  std::string x_label, y_label;  // with units: "time / s"
  bool log_x = false, log_y = false;
  bool equal_axes = false;  // one metre in x is as long as one in y: shapes of threads
  std::vector<Curve> curves;
  std::string caption;  // what is shown, with the parameters
  std::string source;   // of the values compared with; "no published values" where there are none
};

}  // namespace retiarius
