// The order in the mesh at which stretching and bending reach the continuum.
#include "verification/framework/case.hpp"

#include <cmath>

#include <fmt/format.h>

#include "verification/framework/catenary.hpp"
#include "verification/framework/elastica.hpp"
#include "verification/framework/equilibrium.hpp"
#include "verification/framework/line.hpp"
#include "verification/framework/roots.hpp"

namespace retiarius::verification {

namespace {

const char* name_of(Bending kind) { return kind == Bending::bounded ? "bounded" : "tangent"; }

// Errors on meshes each twice as fine as the last one.
struct Ladder {
  std::vector<double> segments, error;

  void add(double count, double e) {
    segments.push_back(count);
    error.push_back(std::abs(e));
  }
  double order() const {
    const std::size_t n = error.size();
    return std::log(error[n - 2] / error[n - 1]) / std::log(segments[n - 1] / segments[n - 2]);
  }
  Curve curve(const std::string& name) const { return {name, segments, error, CurveStyle::line}; }
};

// A vertical line under its own weight: lumped masses sum its tension by the trapezoid's rule,
// which is exact for a tension that falls linearly.
void compare_vertical(Context& context) {
  for (int n : {1, 4, 32}) {
    const Network net = straight_line(n, 2.0, plain_thread(50.0, 0.2), -Vec3::UnitZ());
    const State s = equilibrium(context, net, {0, 0, -9.81}, {0});
    context.relative(fmt::format("extension under its own weight, {} segments", n), "m",
                     -s.x.back().z() - 2.0, 0.2 * 9.81 * 4.0 / (2.0 * 50.0), 1e-9,
                     "no error of the mesh; Newton's tolerance 1e-8 of the load", "w L^2 / (2 EA)");
  }
}

// A soft cable between ends: distance of its nodes from the elastic catenary, root mean square.
Ladder stretching(const Context& context) {
  const ElasticCable cable{1.2, 2.0, 20.0};
  const Eigen::Vector2d forces = end_forces(cable, {1.0, 0.0});
  Ladder ladder;
  for (int n : {8, 16, 32, 64, 128}) {
    Network net = straight_line(n, cable.length, plain_thread(cable.stiffness, 0.2));
    lay_on_arc(net, 1.0);
    const State s = equilibrium(context, net, {0, 0, -10}, {0, n});
    double sum = 0.0;
    for (Index k = 0; k <= n; ++k) {
      const Eigen::Vector2d p = cable.point(forces[0], forces[1], k * cable.length / n);
      sum += (Eigen::Vector2d(s.x[k].x(), s.x[k].z()) - p).squaredNorm();
    }
    ladder.add(n, std::sqrt(sum / n));
  }
  return ladder;
}

// The tip of a cantilever under weight and load, its length measured from the clamp's middle.
Ladder bending(const Context& context, Bending kind) {
  constexpr double kFlexibility = 1e-5;
  const double wanted = cantilever(8.0, 0.0, kFlexibility).back().y;
  Ladder ladder;
  for (int n : {8, 16, 32, 64, 128}) {
    const double h = 1.0 / (n - 0.5);
    const Network net = straight_line(n, n * h, plain_thread(1.0 / kFlexibility, 1.0, 1.0, kind));
    ladder.add(n - 0.5, equilibrium(context, net, {0, 0, -8}, {0, 1}).x.back().z() - wanted);
  }
  return ladder;
}

void run(Context& context) {
  compare_vertical(context);
  Chart chart;
  chart.title = "Convergence in the mesh";
  chart.x_label = "segments / 1";
  chart.y_label = "error / m";
  chart.log_x = chart.log_y = true;
  constexpr const char* kWhy = "the error's next term is of order h^2 of it at 64 segments";
  const Ladder cable = stretching(context);
  context.absolute("order in the mesh, stretching", "1", cable.order(), 2.0, 0.01, kWhy,
                   "elastic catenary (Irvine 1981)");
  chart.curves.push_back(cable.curve("stretching: elastic cable"));
  for (Bending kind : {Bending::bounded, Bending::tangent}) {
    const Ladder rod = bending(context, kind);
    context.absolute(fmt::format("order in the mesh, bending, {}", name_of(kind)), "1", rod.order(),
                     2.0, 0.01, kWhy, "heavy elastica by shooting");
    chart.curves.push_back(rod.curve(fmt::format("bending, {}: cantilever", name_of(kind))));
  }
  Curve slope{"order 2", {8, 128}, {0.02, 0.02 / 256}, CurveStyle::dashed};
  chart.curves.push_back(slope);
  chart.caption =
      "Cable: 1.2 m, 2 N/m, EA 20 N, ends 1 m apart, distance of all nodes (root mean square). "
      "Cantilever: w L^3 / EI = 8, its tip.";
  chart.source = "elastic catenary; heavy elastica by shooting";
  context.chart(chart);
}

}  // namespace

Case mesh_convergence_case() {
  Case c;
  c.name = "mesh-convergence";
  c.title = "Convergence in the mesh: stretching and bending";
  c.group = Group::convergence;
  c.about =
      "An elastic cable and a heavy cantilever on meshes of 8 to 128 segments. Compared: the order "
      "at which they reach the elastic catenary and the elastica with two, and the extension of a "
      "vertical line, which has no error of the mesh at all.";
  c.source = "elastic catenary; heavy elastica by shooting";
  c.guards = {"stretching", "bending", "gravity", "mass"};
  c.run = run;
  return c;
}

}  // namespace retiarius::verification
