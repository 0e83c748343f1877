// Orders of the integrators in the step, against a solution by other means.
#include "verification/framework/case.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "retiarius/motion/integrator.hpp"
#include "verification/framework/line.hpp"
#include "verification/framework/reference_chain.hpp"

namespace retiarius::verification {

namespace {

struct Problem {
  const char* name;
  Network net;
  EnvironmentSpec environment;
  std::vector<Index> held;
  double time = 0.0;  // s
  int steps = 0;      // of the coarsest run
};

// Three soft segments, thrown: they turn, stretch and go slack into compression.
Problem stretching(double tau, double mu) {
  Material m = plain_thread(30.0, 0.05);
  m.damping = tau;
  const char* name = tau > 0.0 ? "stretching, damped" : "stretching";
  Problem p{name,
            line_through({{0, 0, 0}, {1, 0, 0}, {2, 0.3, 0}, {3, 0, 0}}, m),
            {{0, 0, -3}, mu},
            {0},
            0.8,
            100};
  for (double& mass : p.net.mass) mass += 0.1;
  p.net.velocity = {{0, 0, 0}, {0.3, 0, 0.5}, {0.2, -1.5, 0.4}, {0.5, 1.0, 0}};
  return p;
}

// A soft rod held at one end only falls and folds.
Problem bending(double tau, double mu, Bending curvature) {
  Material m = plain_thread(60.0, 0.1, 0.3, curvature);
  m.damping = tau;
  const char* name = tau > 0.0                       ? "bending, damped"
                     : curvature == Bending::tangent ? "bending, tangent curvature"
                                                     : "bending";
  return {name, straight_line(6, 1.5, m), {{0, 0, -4}, mu}, {0}, 0.5, 100};
}

std::vector<Vec3> end_of(Context& context, const Problem& p, Method method, int steps) {
  Network net = p.net;
  Simulation sim = context.simulation(net, kNoBodies);
  const double h = p.time / steps;
  sim.configure(p.environment, with(method, h, 1e-11), {});
  advance(sim, h, steps, held(net, p.held));
  return sim.state().x;
}

std::vector<Vec3> reference(const Problem& p, int steps) {
  ReferenceChain chain(p.net);
  chain.gravity = p.environment.gravity;
  chain.mu = p.environment.damping;
  chain.held = p.held;
  chain.advance(p.time, steps);
  return chain.x;
}

double distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, (a[i] - b[i]).norm());
  return most;
}

// What a scheme's error looks like, and how far its order and its extrapolated end may be off.
struct Expansion {
  double order = 2.0, next = 4.0;
  double order_bound = 0.01;
  double quick_bound = 1e-8, bound = 1e-10;  // m
  const char* order_reason = "the error's next term is of fourth order";
  const char* reason = "of sixth order, but for Newton's tolerance of 1e-11";
};

Expansion expansion(Method method) {
  if (method == Method::implicit_euler)
    return {1.0,
            2.0,
            0.05,
            1e-4,
            2e-6,
            "the error's next term moves it by a few per cent",
            "of third order: a few (omega h)^3 m with the fastest omega of 25 rad/s"};
  if (method == Method::generalised_alpha || method == Method::tr_bdf2)
    return {2.0,
            3.0,
            0.01,
            1e-8,
            1e-10,
            "the error's next term, of third order, moves it by less than a per cent",
            "of fourth order, but for Newton's tolerance of 1e-11"};
  return {};
}

// From the last three runs, whose steps halve: the two leading terms of the error taken away.
std::vector<Vec3> extrapolated(const std::vector<std::vector<Vec3>>& ends, const Expansion& e) {
  const double p = std::exp2(e.order), q = std::exp2(e.next);
  const std::size_t last = ends.size() - 1;
  std::vector<Vec3> limit = ends[last];
  for (std::size_t i = 0; i < limit.size(); ++i) {
    const Vec3 fine = (p * ends[last][i] - ends[last - 1][i]) / (p - 1.0);
    const Vec3 coarse = (p * ends[last - 1][i] - ends[last - 2][i]) / (p - 1.0);
    limit[i] = (q * fine - coarse) / (q - 1.0);
  }
  return limit;
}

void compare(Context& context, const Problem& p) {
  const std::vector<Vec3> exact = reference(p, 8000);
  context.absolute(fmt::format("{}: reference at half its step", p.name), "m",
                   distance(exact, reference(p, 4000)), 0.0, 1e-9,
                   "fourth order: the reference is known far better than any run here",
                   "the reference itself");
  Chart chart;
  chart.title = fmt::format("Error against step: {}", p.name);
  chart.x_label = "step / s";
  chart.y_label = "largest error of a node / m";
  chart.log_x = chart.log_y = true;
  const int levels = context.quick() ? 4 : 6;
  for (Method method : {Method::implicit_euler, Method::newmark, Method::midpoint,
                        Method::generalised_alpha, Method::tr_bdf2}) {
    const Expansion wanted = expansion(method);
    Curve curve{to_string(method), {}, {}, CurveStyle::line};
    std::vector<std::vector<Vec3>> ends;
    for (int level = 0; level < levels; ++level) {
      const int steps = p.steps << level;
      curve.x.push_back(p.time / steps);
      ends.push_back(end_of(context, p, method, steps));
      curve.y.push_back(distance(ends.back(), exact));
    }
    const double last = curve.y.back(), before = curve.y[curve.y.size() - 2];
    context.absolute(fmt::format("{}: order of {}", p.name, to_string(method)), "1",
                     std::log2(before / last), wanted.order, wanted.order_bound,
                     wanted.order_reason, "theory of the scheme");
    context.absolute(fmt::format("{}: end by {}, extrapolated", p.name, to_string(method)), "m",
                     distance(extrapolated(ends, wanted), exact), 0.0,
                     context.quick() ? wanted.quick_bound : wanted.bound, wanted.reason);
    chart.curves.push_back(curve);
  }
  for (int order : {1, 2}) {
    Curve slope{fmt::format("order {}", order), {}, {}, CurveStyle::dashed};
    const Curve& from = chart.curves[static_cast<std::size_t>(order - 1)];
    for (double h : from.x) {
      slope.x.push_back(h);
      slope.y.push_back(0.7 * from.y.back() * std::pow(h / from.x.back(), order));
    }
    chart.curves.push_back(slope);
  }
  chart.caption =
      fmt::format("Largest distance of a node from its place in the reference at {} s.", p.time);
  chart.source = "the same equations written anew, classical Runge-Kutta";
  context.chart(chart);
}

void run(Context& context) {
  for (const Problem& p :
       {stretching(0.0, 0.0), stretching(0.02, 0.5), bending(0.0, 0.0, Bending::bounded),
        bending(0.0, 0.0, Bending::tangent), bending(0.01, 0.5, Bending::bounded)})
    compare(context, p);
}

}  // namespace

Case step_convergence_case() {
  Case c;
  c.name = "step-convergence";
  c.title = "Convergence in the step: orders of the integrators";
  c.group = Group::convergence;
  c.about =
      "A thrown thread of three soft segments held at one end, and a soft rod of six that falls "
      "about its hinge (both curvatures), with and without material and environmental damping, by "
      "each integrator with ever shorter steps. Compared: the end positions with a Runge-Kutta "
      "solution of the same equations, and how their error falls with the step.";
  c.source = "the same equations written anew, classical Runge-Kutta";
  c.guards = {"stretching",          "bending",          "gravity",
              "environment damping", "material damping", "mass"};
  c.run = run;
  return c;
}

}  // namespace retiarius::verification
