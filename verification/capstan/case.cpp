// A thread over a fixed rough cylinder.
#include "verification/framework/case.hpp"

#include <cmath>

#include <fmt/format.h>

#include "retiarius/motion/integrator.hpp"
#include "verification/framework/line.hpp"

namespace retiarius::verification {

namespace {

constexpr double kRadius = 1e-3;  // of the thread, m
constexpr double kDrum = 0.1;     // m
constexpr double kG = 9.81;       // m/s2

Body drum() {
  BodySpec spec;
  spec.shape = ShapeKind::cylinder;
  spec.radius = kDrum;
  spec.length = 1.0;
  spec.motion = BodyMotion::fixed;
  spec.attitude_deg = {90, 0, 0};  // axis along y
  return build_body(spec, "");
}

// A light thread half around the drum, in pieces of pi / wrap, with 1 kg and `heavy` kg on its
// ends.
Network thread_with_masses(int wrap, double heavy) {
  const double r = kDrum + kRadius;
  const double piece = r * kPi / wrap;
  const int leg = wrap;
  std::vector<Vec3> points;
  for (int k = leg; k > 0; --k) points.push_back({-r, 0, -k * piece});
  for (int k = 0; k <= wrap; ++k) {
    const double angle = kPi * k / wrap;
    points.push_back({-r * std::cos(angle), 0, r * std::sin(angle)});
  }
  for (int k = 1; k <= leg; ++k) points.push_back({r, 0, -k * piece});
  Network net = line_through(points, plain_thread(2e4, 1e-3));
  net.materials[0].compression = false;
  net.materials[0].damping = 1e-4;
  net.mass.front() += 1.0;
  net.mass.back() += heavy;
  return net;
}

struct Pull {
  double fallen = 0.0;  // of the heavier mass, m
  double ratio = 0.0;   // of the legs' tensions, mean over the second half of the time
  Curve along;          // tension over that of the light leg against angle, the same mean
};

Pull pull(const Context& context, double friction, double heavy, int wrap, double time) {
  const std::vector<Body> bodies{drum()};
  Network net = thread_with_masses(wrap, heavy);
  Simulation sim = context.simulation(net, bodies);
  sim.configure({{0, 0, -kG}, 0.0}, with(Method::implicit_euler),
                context.contact({ContactMethod::modified_mass, friction}));
  const double h = 1e-3;
  const int steps = static_cast<int>(std::lround(time / h));
  std::vector<double> sum(net.segments.size(), 0.0);
  advance(sim, h, steps, {}, [&](int k) {
    if (k <= steps / 2) return;
    for (std::size_t s = 0; s < sum.size(); ++s) sum[s] += sim.tensions()[s];
  });
  Pull p;
  p.fallen = net.initial.back().z() - sim.state().x.back().z();
  p.ratio = sum.back() / sum.front();
  for (int k = 0; k < wrap; ++k) {
    p.along.x.push_back((k + 0.5) * 180.0 / wrap);
    p.along.y.push_back(sum[wrap + k] / sum.front());
  }
  return p;
}

// Eytelwein's heaviest load, and how far a heavier one falls from rest in a time: both masses and
// the thread move with (m2 - r m1) g / (m2 + r m1), r = e^(mu pi).
double fall(double friction, double heavy, double time) {
  const double r = std::exp(friction * kPi);
  return 0.5 * (heavy - r) / (heavy + r) * kG * time * time;
}

void run(Context& context) {
  for (double f : {0.1, 0.2, 0.3, 0.5})
    for (int w : {18, 36, 72, 144}) {
      const double r = std::exp(f * kPi);
      const Pull p = pull(context, f, 1.6 * r, w, 0.2);
      context.relative(fmt::format("{} {}", f, w), "1", p.ratio, r, 0.01, "x");
      context.relative(fmt::format("fall {} {}", f, w), "1", p.fallen, fall(f, 1.6 * r, 0.2), 0.01,
                       "x");
      const Pull q = pull(context, f, 0.95 * r, w, 0.15);
      context.absolute(fmt::format("hold {} {}", f, w), "1", q.fallen, 0, 0.001, "x");
    }
}

}  // namespace

Case capstan_case() {
  Case c;
  c.name = "capstan";
  c.title = "Thread over a rough drum";
  c.group = Group::contact;
  c.source = "Euler and Eytelwein";
  c.run = run;
  return c;
}

}  // namespace retiarius::verification
