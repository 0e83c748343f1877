// A mass slides off a smooth fixed ball.
#include "verification/framework/case.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "retiarius/motion/integrator.hpp"
#include "verification/framework/line.hpp"

namespace retiarius::verification {

namespace {

constexpr double kRadius = 1e-3;  // of the thread, m
constexpr double kBall = 1.0;     // m
constexpr double kStart = 0.1;    // rad from the top
constexpr double kG = 9.81;       // m/s2
constexpr Method kMethods[] = {Method::implicit_euler, Method::newmark, Method::midpoint};

Body ball() {
  BodySpec spec;
  spec.radius = kBall;
  spec.motion = BodyMotion::fixed;
  return build_body(spec, "");
}

// Two equal masses side by side, joined by a thread that stays slack.
Network two_masses() {
  const double r = kBall + kRadius;
  const Vec3 start(r * std::sin(kStart), 0, r * std::cos(kStart));
  Network net = line_through({start - 1e-7 * Vec3::UnitY(), start + 1e-7 * Vec3::UnitY()},
                             plain_thread(100.0, 1e-9));
  net.materials[0].compression = false;
  net.segments[0].rest_length = 1.0;
  net.mass = {0.5, 0.5};
  return net;
}

struct Slide {
  Curve height;        // cosine of the angle from the top, against time
  double left = 0.0;   // the same where the mass leaves the ball
  double speed = 0.0;  // m/s, there
};

Slide slide(const Context& context, Method method, double h) {
  const std::vector<Body> bodies{ball()};
  Network net = two_masses();
  Simulation sim = context.simulation(net, bodies);
  sim.configure({{0, 0, -kG}, 0.0}, with(method),
                context.contact({ContactMethod::modified_mass, 0.0}));
  Slide result;
  result.height.name = to_string(method);
  const int count = static_cast<int>(std::lround(1.5 / h));
  advance(sim, h, count, {}, [&](int k) {
    if (result.left > 0.0) return;
    result.height.x.push_back(k * h);
    result.height.y.push_back(sim.state().x[0].normalized().z());
    if (k == 1 || !sim.state().touches.empty()) return;
    result.left = result.height.y.back();
    result.speed = sim.state().v[0].norm();
  });
  return result;
}

// cos of the angle against time: theta'' = (g / r) sin theta, by Runge and Kutta.
Curve exact() {
  Curve curve{"point mass on the ball", {}, {}, CurveStyle::points};
  const double w2 = kG / (kBall + kRadius), h = 1e-3, leaves = 2.0 / 3.0 * std::cos(kStart);
  using Pair = std::array<double, 2>;
  const auto rate = [w2](const Pair& y) { return Pair{y[1], w2 * std::sin(y[0])}; };
  const auto ahead = [](const Pair& y, double s, const Pair& f) {
    return Pair{y[0] + s * f[0], y[1] + s * f[1]};
  };
  Pair y{kStart, 0.0};
  for (int k = 0; std::cos(y[0]) > leaves; ++k) {
    if (k % 50 == 0) {
      curve.x.push_back(k * h);
      curve.y.push_back(std::cos(y[0]));
    }
    const Pair a = rate(y), b = rate(ahead(y, 0.5 * h, a)), c = rate(ahead(y, 0.5 * h, b)),
               d = rate(ahead(y, h, c));
    for (int i = 0; i < 2; ++i) y[i] += h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]);
  }
  return curve;
}

void compare_motion(Context& context, const Slide& s, const Curve& path, const std::string& name) {
  const std::size_t k = path.x.size() - 2;
  const std::size_t same = static_cast<std::size_t>(std::lround(path.x[k] / 5e-4)) - 1;
  context.absolute(fmt::format("cosine at {:.2f} s, {}", path.x[k], name), "1",
                   s.height.y[std::min(same, s.height.y.size() - 1)], path.y[k], 0.006,
                   "first order with h = 0.5 ms where a touching node starts from the chord",
                   "point mass on a smooth ball, Runge-Kutta");
}

void run(Context& context) {
  const double leaves = 2.0 / 3.0 * std::cos(kStart);
  const double speed = std::sqrt(2.0 * kG * (kBall + kRadius) * (std::cos(kStart) - leaves));
  const Curve path = exact();
  Chart chart;
  chart.title = "A mass slides off a smooth ball";
  chart.x_label = "time / s";
  chart.y_label = "cosine of the angle from the top";
  chart.caption =
      "From rest 0.1 rad from the top of a fixed ball of 1 m; h = 0.5 ms. Curves end where the "
      "mass "
      "leaves.";
  chart.source = "energy, and no force on the surface: cos = 2/3 cos(start)";
  for (Method method : kMethods) {
    const Slide s = slide(context, method, 5e-4);
    const std::string name = to_string(method);
    context.relative(
        "cosine where the mass leaves, " + name, "1", s.left, leaves, 0.01,
        "the release is seen at a step's end: 2 h v sin / r = 0.004, and first order in "
        "the speed");
    context.relative("speed there, " + name, "m/s", s.speed, speed, 0.01,
                     "the square root of twice the fallen height, with its error above");
    compare_motion(context, s, path, name);
    chart.curves.push_back(s.height);
  }
  chart.curves.push_back(path);
  chart.curves.push_back({"leaves", {0.0, path.x.back()}, {leaves, leaves}, CurveStyle::dashed});
  context.chart(chart);
  Chart order;
  order.title = "Where the mass leaves, as the step is refined";
  order.x_label = "step / s";
  order.y_label = "error of the cosine, relative";
  order.log_x = order.log_y = true;
  order.caption = "Against 2/3 cos(start).";
  order.source = chart.source;
  for (Method method : kMethods) {
    Curve curve{to_string(method), {}, {}};
    for (double h : {4e-3, 2e-3, 1e-3, 5e-4}) {
      curve.x.push_back(h);
      curve.y.push_back(std::abs(slide(context, method, h).left / leaves - 1.0));
    }
    order.curves.push_back(curve);
  }
  context.chart(order);
}

}  // namespace

Case sphere_slide_case() {
  Case c;
  c.name = "sphere-slide";
  c.title = "A mass slides off a smooth ball";
  c.group = Group::contact;
  c.about =
      "A point mass slides from rest, 0.1 rad from the top of a smooth fixed ball of 1 m, under "
      "9.81 m/s2. Compared: where it leaves (cos = 2/3 of its start's), its speed there, and its "
      "motion before with that of a point mass.";
  c.source = "energy, and no force on the surface: cos = 2/3 cos(start)";
  c.guards = {"gravity"};
  c.run = run;
  return c;
}

}  // namespace retiarius::verification
