// A mass bounces between two slack threads.
#include "verification/framework/case.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "retiarius/motion/integrator.hpp"
#include "verification/framework/line.hpp"

namespace retiarius::verification {

namespace {

constexpr double kRest = 1.0, kSpan = 0.95, kSlack = kRest - kSpan;  // m
constexpr double kMass = 1.0, kSpeed = 1.0, kOmega = 20.0;
constexpr double kStiffness = kMass * kOmega * kOmega * kRest;  // EA, N

// A bounce: the thread pulls by k (q + tau q') from q = 0 at speed v until that would push.
struct Bounce {
  double time = 0.0;         // s, of the pull
  double end = 0.0;          // q / v when it lets go, s
  double restitution = 0.0;  // speed after over speed before

  explicit Bounce(double zeta) {
    const double wd = kOmega * std::sqrt(1.0 - zeta * zeta), tau = 2.0 * zeta / kOmega;
    time = (kPi - std::atan2(tau * wd, 1.0 - 2.0 * zeta * zeta)) / wd;
    end = at(zeta, time);
    const double decay = std::exp(-zeta * kOmega * time);
    restitution = -decay * (std::cos(wd * time) - zeta * kOmega / wd * std::sin(wd * time));
  }
  static double at(double zeta, double t) {
    const double wd = kOmega * std::sqrt(1.0 - zeta * zeta);
    return std::exp(-zeta * kOmega * t) * std::sin(wd * t) / wd;
  }
};

// The exact path: free flight, pull of a thread, free flight to the other side.
double exact_place(double t, double zeta) {
  const Bounce bounce(zeta);
  double speed = kSpeed, side = 1.0, flight = kSlack / speed, from = 0.0;
  for (;;) {
    if (t < flight) return side * (from + speed * t);
    t -= flight;
    if (t < bounce.time) return side * (kSlack + speed * Bounce::at(zeta, t));
    t -= bounce.time;
    from = -(kSlack + speed * bounce.end);
    speed *= bounce.restitution;
    side = -side;
    flight = (kSlack - from) / speed;
  }
}

struct Run {
  std::vector<double> t, x, speed, tension;
};

Run bounce(Context& context, Method method, double zeta, double h, double time) {
  Material material = plain_thread(kStiffness, 1e-12);
  material.compression = false;
  material.damping = 2.0 * zeta / kOmega;
  Network net = line_through({{-kSpan, 0, 0}, {0, 0, 0}, {kSpan, 0, 0}}, material);
  for (Segment& s : net.segments) s.rest_length = kRest;
  net.mass[1] = kMass;
  net.velocity[1] = {kSpeed, 0, 0};
  Simulation sim = context.simulation(net, kNoBodies);
  sim.configure({}, with(method, h, 1e-10), {});
  Run run{{0.0}, {0.0}, {kSpeed}, {0.0}};
  advance(sim, h, static_cast<int>(std::lround(time / h)), held(net, {0, 2}), [&](int) {
    run.t.push_back(sim.state().time);
    run.x.push_back(sim.state().x[1].x());
    run.speed.push_back(sim.state().v[1].x());
    run.tension.push_back(*std::max_element(sim.tensions().begin(), sim.tensions().end()));
  });
  return run;
}

// Passes of the middle, interpolated, s, with the speeds there.
std::vector<std::pair<double, double>> passes(const Run& run) {
  std::vector<std::pair<double, double>> found;
  for (std::size_t k = 2; k < run.t.size(); ++k) {
    const double a = run.x[k - 1], b = run.x[k];
    if (a * b < 0.0)
      found.emplace_back(run.t[k - 1] + (run.t[k] - run.t[k - 1]) * a / (a - b),
                         std::abs(run.speed[k]));
  }
  return found;
}

void compare(Context& context, Method method, double zeta, Chart& chart) {
  const double h = context.quick() ? 1e-3 : 2.5e-4, time = context.quick() ? 1.2 : 2.5;
  const Run run = bounce(context, method, zeta, h, time);
  const std::string what = fmt::format("damping ratio {}, {}", zeta, to_string(method));
  const Bounce one(zeta);
  const std::vector<std::pair<double, double>> found = passes(run);
  // A bounce of the midpoint rule sees the jump of the viscous pull only once its stage is taut.
  const bool jumps = zeta > 0.0 && method == Method::midpoint;
  const double smooth = std::pow(kOmega * h, 2), jump = jumps ? zeta * kOmega * h : 0.0;
  const std::string argument =
      jumps ? "up to zeta omega h of the speed at every jump of the viscous pull"
            : "(omega h)^2: second order, where the threads become taut and slack too";
  double wanted_time = 0.0, speed = kSpeed;
  for (std::size_t k = 0; k < std::min<std::size_t>(found.size(), 3); ++k) {
    wanted_time += kSlack / speed + one.time;
    const double back = speed * one.end;
    speed *= one.restitution;
    wanted_time += (kSlack + back) / speed;
    context.relative(fmt::format("pass {} of the middle, {}", k + 1, what), "s", found[k].first,
                     wanted_time, smooth + (k + 1.0) * jump, argument);
    context.relative(fmt::format("speed there {}, {}", k + 1, what), "m/s", found[k].second, speed,
                     smooth + (k + 1.0) * jump, argument);
  }
  const double peak = *std::max_element(run.tension.begin(), run.tension.end());
  double wanted_peak = 0.0;
  for (int k = 0; k <= 10000; ++k) {
    const double t = one.time * k / 10000, wd = kOmega * std::sqrt(1.0 - zeta * zeta);
    const double q = Bounce::at(zeta, t);
    const double rate =
        std::exp(-zeta * kOmega * t) * (std::cos(wd * t) - zeta * kOmega / wd * std::sin(wd * t));
    wanted_peak =
        std::max(wanted_peak, kStiffness / kRest * kSpeed * (q + 2.0 * zeta / kOmega * rate));
  }
  context.relative("largest tension, " + what, "N", peak, wanted_peak, smooth,
                   "(omega h)^2: second order, the largest of samples");
  double worst = 0.0;
  for (std::size_t k = 0; k < run.t.size(); ++k)
    worst = std::max(worst, std::abs(run.x[k] - exact_place(run.t[k], zeta)));
  context.absolute("largest difference of the path, " + what, "m", worst, 0.0,
                   smooth + 0.1 * static_cast<double>(found.size()) * jump,
                   argument + ", over 0.1 m");
  if (method != Method::midpoint) return;
  Curve ours{fmt::format("damping ratio {}", zeta), {}, {}, CurveStyle::line};
  Curve exact{fmt::format("exact, {}", zeta), {}, {}, CurveStyle::dashed};
  for (std::size_t k = 0; k < run.t.size(); k += 1 + run.t.size() / 1500) {
    ours.x.push_back(run.t[k]);
    ours.y.push_back(run.x[k]);
    exact.x.push_back(run.t[k]);
    exact.y.push_back(exact_place(run.t[k], zeta));
  }
  chart.curves.push_back(ours);
  chart.curves.push_back(exact);
}

// A half swing of implicit Euler: each step turns by atan(omega h) and divides the speed by
// sqrt(1 + (omega h)^2).
void compare_euler(Context& context) {
  const double h = context.quick() ? 1e-3 : 2.5e-4, x = kOmega * h;
  const Run run = bounce(context, Method::implicit_euler, 0.0, h, 0.6);
  const double wanted = std::exp(-0.5 * std::log1p(x * x) * kPi / std::atan(x));
  context.relative("speed after a bounce, damping ratio 0, implicit-euler", "m/s",
                   passes(run).at(0).second, wanted, 2.0 * x * x,
                   "(omega h)^2 for each of the two steps in which the pull begins and ends",
                   "exact for the scheme: (1 + (omega h)^2)^(-pi / (2 atan(omega h)))");
}

void run(Context& context) {
  Chart chart;
  chart.title = "A mass between two slack threads";
  chart.x_label = "time / s";
  chart.y_label = "place of the mass / m";
  for (double zeta : {0.0, 0.1})
    for (Method method : {Method::midpoint, Method::newmark}) compare(context, method, zeta, chart);
  compare_euler(context);
  chart.caption =
      "1 kg at 1 m/s between two threads of 1 m that reach 0.95 m (EA 400 N, 20 rad/s), midpoint; "
      "the threads pull and do not push.";
  chart.source = "exact: free flight and damped half swings, joined";
  context.chart(chart);
  context.note(
      "A damped thread that becomes taut at speed v pulls at once with EA tau v / l0. The midpoint "
      "rule sees the thread taut only where its stage is, and errs by up to zeta omega h of the "
      "speed at each such jump; Newmark keeps its second order here.");
}

}  // namespace

Case tension_only_case() {
  Case c;
  c.name = "tension-only";
  c.title = "A mass between slack threads that only pull";
  c.group = Group::dynamics;
  c.about =
      "A mass of 1 kg flies at 1 m/s between two threads, each slack by 5 cm, that pull and do not "
      "push (20 rad/s), without and with material damping (0.1 of critical). Compared: its passes "
      "of the middle, its speed after each bounce, the largest tension and the whole path with the "
      "exact solution by pieces.";
  c.source = "exact: free flight and damped half swings, joined";
  c.guards = {"stretching", "material damping", "mass"};
  c.run = run;
  return c;
}

}  // namespace retiarius::verification
