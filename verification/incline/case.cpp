// A mass on an inclined plane: stick and slip.
#include "verification/framework/case.hpp"

#include <cmath>

#include <fmt/format.h>

#include "retiarius/motion/integrator.hpp"
#include "verification/framework/line.hpp"

namespace retiarius::verification {

namespace {

constexpr double kRadius = 1e-3;  // of the thread, m
constexpr double kPressed = (1.0 - 2e-3) * kRadius;
constexpr double kG = 9.81;      // m/s2
constexpr double kSlope = 30.0;  // degrees
constexpr Method kMethods[] = {Method::implicit_euler, Method::newmark, Method::midpoint};

Body plane() {
  BodySpec spec;
  spec.shape = ShapeKind::plane;
  spec.motion = BodyMotion::fixed;
  spec.attitude_deg = {0, kSlope, 0};  // falls towards +x
  return build_body(spec, "");
}

// Two equal masses at one height on the plane, joined by a thread. They start pressed in by 2
// thousandths of its radius, so that they touch from the start.
Network two_masses(const Vec3& normal) {
  const Vec3 side = 0.05 * Vec3::UnitY();
  Network net =
      line_through({kPressed * normal - side, kPressed * normal + side}, plain_thread(100.0, 1e-9));
  net.mass = {0.5, 0.5};
  return net;
}

// Displacement against time.
Curve displacement(const Context& context, Method method, double friction, double speed, double h,
                   double time) {
  const std::vector<Body> bodies{plane()};
  const Quat& attitude = bodies[0].initial.attitude;
  Network net = two_masses(attitude * Vec3::UnitZ());
  net.velocity.assign(2, speed * (attitude * Vec3::UnitX()));
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

// Where the mass is at 0.02 s and how fast: entering contact, it is pushed out of the plane within
// a step, and friction that belongs to that push takes some mm/s.
struct Later {
  double way = 0.0, speed = 0.0;
};
Later after_start(const Curve& curve) {
  const double h = curve.x[0];
  const std::size_t k = static_cast<std::size_t>(std::lround(0.02 / h)) - 1;
  return {curve.y[k], (curve.y[k + 1] - curve.y[k - 1]) / (2.0 * h)};
}

double acceleration(double friction) {
  return kG * (std::sin(radians(kSlope)) - friction * std::cos(radians(kSlope)));
}

// Thrown downhill at 1 m/s, so that the slip is far above the speeds at which friction is smoothed.
void compare_slip(Context& context) {
  const double h = 1e-3, t = 0.5, v = 1.0;
  Chart chart;
  chart.title = "A mass slides down a rough plane of 30 degrees";
  chart.x_label = "time / s";
  chart.y_label = "distance / m";
  Curve exact{"v t + a t^2 / 2", {}, {}, CurveStyle::points};
  for (double friction : {0.1, 0.3, 0.5, 0.7}) {
    const double a = acceleration(friction);
    for (Method method : kMethods) {
      Curve curve = displacement(context, method, friction, v, h, t);
      const Later later = after_start(curve);
      context.relative(
          fmt::format("distance from 0.02 to 0.5 s at mu = {}, {}", friction, to_string(method)),
          "m", curve.y.back() - later.way, later.speed * 0.48 + 0.5 * a * 0.48 * 0.48, 5e-6,
          "uniform acceleration, which central differences of the way take exactly; smoothed "
          "friction "
          "lacks delta^2 / 2 v^2 of itself, 2e-6 at the 0.5 m/s that mu = 0.7 ends with");
      if (method != Method::implicit_euler) continue;
      curve.name = fmt::format("mu = {}", friction);
      chart.curves.push_back(curve);
    }
    for (int k = 0; k <= 10; ++k) {
      exact.x.push_back(0.05 * k);
      exact.y.push_back(0.05 * k * v + 0.5 * a * 0.0025 * k * k);
    }
  }
  chart.curves.push_back(exact);
  chart.caption = "Thrown downhill at 1 m/s; implicit Euler, h = 1 ms, 9.81 m/s2.";
  chart.source = "a = g (sin - mu cos)";
  context.chart(chart);
}

// Beyond the limit a mass that is thrown stops after v / |a| and v^2 / 2|a|.
void compare_stop(Context& context) {
  const double friction = 1.0, v = 1.0, h = 5e-4;
  const double a = -acceleration(friction);
  for (Method method : kMethods) {
    const Curve way = displacement(context, method, friction, v, h, 0.6);
    const Later later = after_start(way);
    const std::size_t stop = static_cast<std::size_t>(std::ceil((0.02 + later.speed / a) / h)) - 1;
    context.relative(
        fmt::format("way from 0.02 s until it should stop at mu = 1, {}", to_string(method)), "m",
        way.y[stop] - later.way, 0.5 * later.speed * later.speed / a, 5e-5,
        "smoothed friction below 1 mm/s; the stop falls within a step", "v^2 / 2|a|");
    if (method != Method::implicit_euler) continue;
    context.note(fmt::format(
        "A mass that slides sticks once friction can take all its momentum within one step. After "
        "it should have stopped it moves by {:.2f} mm in {:.2f} s (h = 0.5 ms, mu = 1).",
        1e3 * (way.y.back() - way.y[stop]), 0.6 - v / a));
  }
}

void compare_stick(Context& context) {
  const double tangent = std::tan(radians(kSlope));
  for (Method method : kMethods)
    context.absolute(
        fmt::format("distance in 1 s from rest at mu = 1.02 tan(slope), {}", to_string(method)),
        "m", displacement(context, method, 1.02 * tangent, 0.0, 0.01, 1.0).y.back(), 0.0, 2.1e-6,
        "the mass starts 2e-6 m pressed into the plane, which pushes it out at once",
        "Coulomb: sticks");
}

// From rest near the limit: where the smoothing of friction shows.
void draw_start(Context& context) {
  const double tangent = std::tan(radians(kSlope));
  const double friction = 0.98 * tangent;
  Chart chart;
  chart.title = "From rest, just below and above the limit of friction";
  chart.x_label = "time / s";
  chart.y_label = "distance / m";
  Curve exact{"Coulomb, mu = 0.98 tan", {}, {}, CurveStyle::points};
  Curve slips = displacement(context, Method::implicit_euler, friction, 0.0, 1e-3, 3.0);
  Curve sticks = displacement(context, Method::implicit_euler, 1.02 * tangent, 0.0, 1e-3, 3.0);
  slips.name = "mu = 0.98 tan(slope)";
  sticks.name = "mu = 1.02 tan(slope)";
  for (int k = 0; k <= 15; ++k) {
    exact.x.push_back(0.2 * k);
    exact.y.push_back(0.5 * acceleration(friction) * 0.04 * k * k);
  }
  const double a = (slips.y[2999] - 2.0 * slips.y[1999] + slips.y[999]);
  context.relative(
      "acceleration from 1 to 3 s at mu = 0.98 tan(slope), from rest", "m/s2", a,
      acceleration(friction), 0.002,
      "friction lacks delta^2 / 2 v^2 of itself: mu g cos times 5e-7 / v^2, at 0.1 to 0.3 m/s on "
      "average a thousandth of the small difference that accelerates",
      "a = g (sin - mu cos)");
  chart.curves = {slips, sticks, exact};
  chart.caption = "Implicit Euler, h = 1 ms.";
  chart.source = "a = g (sin - mu cos)";
  context.chart(chart);
  context.note(fmt::format(
      "Friction is smoothed: at a slip velocity v it is v / sqrt(v^2 + (1 mm/s)^2) of Coulomb's. "
      "Starting from rest within 2 % of the limit the whole acceleration, {:.3f} m/s2, is a small "
      "difference of large forces, and what is missing of friction below a centimetre per second "
      "shows: after 1 s the mass is {:.1f} cm down instead of {:.1f} cm. The limit itself is "
      "sharp, since a mass at rest sticks without smoothing.",
      acceleration(friction), 100.0 * slips.y[999], 50.0 * acceleration(friction)));
}

void run(Context& context) {
  compare_slip(context);
  compare_stop(context);
  compare_stick(context);
  draw_start(context);
}

}  // namespace

Case incline_case() {
  Case c;
  c.name = "incline";
  c.title = "Stick and slip on an incline";
  c.group = Group::contact;
  c.about =
      "A mass on a fixed plane of 30 degrees with Coulomb friction: thrown downhill it "
      "slides with g (sin - mu cos), beyond the limit it stops, and from rest it sticks. Three "
      "integrators.";
  c.source = "Coulomb";
  c.guards = {"gravity", "friction"};
  c.run = run;
  return c;
}

}  // namespace retiarius::verification
