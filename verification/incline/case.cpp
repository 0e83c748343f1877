// A mass on an inclined plane: stick and slip.
#include "verification/framework/case.hpp"

#include <cmath>

#include <fmt/format.h>

#include "retiarius/motion/integrator.hpp"
#include "verification/framework/line.hpp"

namespace retiarius::verification {

namespace {

constexpr double kRadius = 1e-3;  // of the thread, m
constexpr double kG = 9.81;       // m/s2
constexpr double kSlope = 30.0;   // degrees
constexpr Method kMethods[] = {Method::implicit_euler, Method::newmark, Method::midpoint};

Body plane() {
  BodySpec spec;
  spec.shape = ShapeKind::plane;
  spec.motion = BodyMotion::fixed;
  spec.attitude_deg = {0, kSlope, 0};  // falls towards +x
  return build_body(spec, "");
}

// Two equal masses at one height on the plane, joined by a thread.
Network two_masses(const Vec3& normal) {
  const Vec3 side = 0.05 * Vec3::UnitY();
  Network net =
      line_through({kRadius * normal - side, kRadius * normal + side}, plain_thread(100.0, 1e-9));
  net.mass = {0.5, 0.5};
  return net;
}

// Displacement against time.
Curve displacement(const Context& context, Method method, double friction, double h, double time) {
  const std::vector<Body> bodies{plane()};
  Network net = two_masses(bodies[0].initial.attitude * Vec3::UnitZ());
  Simulation sim = context.simulation(net, bodies);
  sim.configure({{0, 0, -kG}, 0.0}, with(method),
                context.contact({ContactMethod::modified_mass, friction}));
  Curve curve{"", {}, {}};
  advance(sim, h, static_cast<int>(std::lround(time / h)), {}, [&](int k) {
    curve.x.push_back(k * h);
    curve.y.push_back((sim.state().x[0] - net.initial[0]).norm());
  });
  return curve;
}

double acceleration(double friction) {
  return kG * (std::sin(radians(kSlope)) - friction * std::cos(radians(kSlope)));
}

void compare_slip(Context& context, Chart& chart) {
  const double h = 1e-3, t = 0.5;
  for (Method method : kMethods) {
    for (double friction : {0.1, 0.3, 0.5}) {
      Curve curve = displacement(context, method, friction, h, t);
      const double a = acceleration(friction);
      // While it is slower than 1 cm/s the mass counts as nearly at rest, with less friction.
      const double slow = 0.01 * 0.01 / a + 0.01 * (t - 0.01 / a);
      context.relative(
          fmt::format("distance slid in {} s at mu = {}, {}", t, friction, to_string(method)), "m",
          curve.y.back(), 0.5 * a * t * t,
          0.5 * (h / t + 2.0 * slow * friction * kG / (a * a * t * t) * 0.1) + 4e-3,
          "implicit Euler: h / t = 0.002; friction is smoothed below 1 cm/s, which "
          "lasts 1 cm/s / a and leaves at most that speed too much",
          "a = g (sin - mu cos)");
      if (method != Method::implicit_euler) continue;
      curve.name = fmt::format("mu = {}", friction);
      chart.curves.push_back(curve);
    }
  }
}

void compare_stick(Context& context) {
  const double tangent = std::tan(radians(kSlope));
  for (Method method : kMethods) {
    const std::string name = to_string(method);
    const double stuck = displacement(context, method, 1.02 * tangent, 0.01, 1.0).y.back();
    context.absolute("distance in 1 s at mu = 1.02 tan(slope), " + name, "m", stuck, 0.0, 2.6e-5,
                     "entry is found to a twentieth of the thread's radius along the path, half of "
                     "it downhill",
                     "Coulomb: sticks");
    const double slid = displacement(context, method, 0.98 * tangent, 1e-3, 1.0).y.back();
    context.relative("distance in 1 s at mu = 0.98 tan(slope), " + name, "m", slid,
                     0.5 * acceleration(0.98 * tangent), 0.15,
                     "the mass is slower than 1 cm/s for 0.1 s, in which friction is smoothed: up "
                     "to 1 cm/s too much for 0.9 s of an average of 5 cm/s",
                     "a = g (sin - mu cos)");
  }
}

void run(Context& context) {
  Chart chart;
  chart.title = "A mass slides down a rough plane of 30 degrees";
  chart.x_label = "time / s";
  chart.y_label = "distance / m";
  compare_slip(context, chart);
  Curve exact{"a t^2 / 2", {}, {}, CurveStyle::points};
  for (double friction : {0.1, 0.3, 0.5}) {
    for (int k = 0; k <= 10; ++k) {
      exact.x.push_back(0.05 * k);
      exact.y.push_back(0.5 * acceleration(friction) * 0.0025 * k * k);
    }
  }
  chart.curves.push_back(exact);
  chart.caption = "Implicit Euler, h = 1 ms, 9.81 m/s2.";
  chart.source = "a = g (sin - mu cos)";
  context.chart(chart);
  compare_stick(context);
}

}  // namespace

Case incline_case() {
  Case c;
  c.name = "incline";
  c.title = "Stick and slip on an incline";
  c.group = Group::contact;
  c.about =
      "A mass on a fixed plane of 30 degrees with Coulomb friction: below the limit it slides with "
      "g (sin - mu cos), just above it sticks. Three integrators.";
  c.source = "Coulomb";
  c.guards = {"gravity", "friction"};
  c.run = run;
  return c;
}

}  // namespace retiarius::verification
