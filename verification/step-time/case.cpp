// Time of a step against the number of nodes, from the last recorded benchmarks.
#include "verification/framework/case.hpp"

#include <fmt/format.h>

namespace retiarius::verification {

namespace {

// The rows of one branch of the family at h = 0.01 s on one thread.
Curve branch(const Table& table, double s, double across, const std::string& name) {
  Curve curve{name, {}, {}, CurveStyle::line};
  for (std::size_t k = 0; k < table.rows(); ++k) {
    if (table["s"][k] != s || table["across"][k] != across) continue;
    if (table["h"][k] != 0.01 || table["threads"][k] != 1.0) continue;
    if (table["iterations"][k] <= 1.0) continue;  // single updates, not converged
    curve.x.push_back(table["nodes"][k]);
    curve.y.push_back(1e3 * table["step"][k]);
  }
  return curve;
}

void run(Context& context) {
  const Table table = context.table("step-time");
  Chart chart;
  chart.title = "Time of a step against the number of nodes";
  chart.x_label = "nodes";
  chart.y_label = "time of a step / ms";
  chart.log_x = chart.log_y = true;
  chart.curves.push_back(branch(table, 3.0, 1.0, "3 inner nodes a piece, bending across knots"));
  chart.curves.push_back(branch(table, 9.0, 1.0, "9 inner nodes, across knots"));
  chart.curves.push_back(branch(table, 9.0, 0.0, "9 inner nodes, hinged knots"));
  chart.curves.push_back({"real time at h = 0.01 s", {500, 30000}, {10, 10}, CurveStyle::dashed});
  chart.curves.push_back(
      {"Huang et al. 2022: real time up to N = 1,000", {1000}, {10}, CurveStyle::points});
  chart.caption =
      "Hexagon family (side 1 m, E 1 MPa, bounded bending, h = 0.01 s, tolerance 1e-6), one "
      "thread, "
      "mean over the first 100 steps; from the last recorded run of `retiarius bench`.";
  chart.source = "Huang et al. (2022): one thread of an i7-6600U, Eigen and PARDISO";
  context.chart(chart);
  context.note(
      "Measured, not verified: times depend on the machine, so that nothing is compared. The "
      "recorded results name the processor.");
}

}  // namespace

Case step_time_case() {
  Case c;
  c.name = "step-time";
  c.title = "Time of a step against the number of nodes";
  c.group = Group::paper;
  c.figure = "Fig. 16";
  c.about =
      "The last recorded benchmarks (benchmarks/results/step-time.csv, remade by `retiarius "
      "bench`) "
      "beside the paper's statement that nets up to 1,000 nodes run in real time.";
  c.source = "recorded benchmarks";
  c.run = run;
  return c;
}

}  // namespace retiarius::verification
