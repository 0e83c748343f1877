// A thread over a fixed rough cylinder: Euler and Eytelwein's T2 / T1 = e^(mu theta).
#include <gtest/gtest.h>

#include "retiarius/motion/integrator.hpp"
#include "tests/contact/scene.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

constexpr double kDrum = 0.1;      // m, radius of the cylinder
constexpr double kFriction = 0.2;  // e^(0.2 pi) = 1.874456
constexpr double kG = 9.81;        // m/s2
constexpr int kLeg = 30, kWrap = 36;

std::vector<Body> drum() {
  BodySpec spec;
  spec.shape = ShapeKind::cylinder;
  spec.radius = kDrum;
  spec.length = 1.0;
  spec.motion = BodyMotion::fixed;
  spec.attitude_deg = {90, 0, 0};  // axis along y
  return {build_body(spec, "")};
}

// A light thread half around the drum with 1 kg and `heavy` kg on its ends.
Network thread_with_masses(double heavy) {
  const double r = kDrum + kRadius;
  const double piece = r * kPi / kWrap;
  std::vector<Vec3> points;
  for (int k = kLeg; k > 0; --k) points.push_back({-r, 0, -k * piece});
  for (int k = 0; k <= kWrap; ++k) {
    const double angle = kPi * k / kWrap;
    points.push_back({-r * std::cos(angle), 0, r * std::sin(angle)});
  }
  for (int k = 1; k <= kLeg; ++k) points.push_back({r, 0, -k * piece});
  Material m = thread_material(2e4, 1e-3, kRadius);
  m.compression = false;
  m.damping = 1e-4;
  Network net = chain(points, m);
  net.mass.front() += 1.0;
  net.mass.back() += heavy;
  return net;
}

struct Pull {
  double moved = 0.0;  // of the heavier mass, m, downwards
  double ratio = 0.0;  // of the legs' tensions, mean over the second half of the time
};

Pull pull(double heavy, double time) {
  const std::vector<Body> bodies = drum();
  const Network net = thread_with_masses(heavy);
  Simulation sim(net, bodies, initial_state(net, bodies));
  sim.configure({{0, 0, -kG}, 0.0}, with(Method::implicit_euler), touching(kFriction));
  const int steps = static_cast<int>(std::lround(time / 1e-3));
  double light_leg = 0.0, heavy_leg = 0.0;
  run(sim, 1e-3, steps, {}, [&](int k) {
    if (k <= steps / 2) return;
    light_leg += sim.tensions().front();
    heavy_leg += sim.tensions().back();
  });
  return {net.initial.back().z() - sim.state().x.back().z(), heavy_leg / light_leg};
}

// Below the limit the drum holds; free, the mass would fall by (0.7 / 2.7) g t^2 / 2 = 29 mm.
TEST(Capstan, HoldsBelowItsLimit) {
  const Pull p = pull(1.7, 0.15);
  EXPECT_LT(p.moved, 2e-3);
  EXPECT_NEAR(p.ratio, 1.7, 0.05);
}

// Above it the thread slides; the ratio of tensions is e^(mu pi) whatever the masses. Nodes 5
// degrees apart enter and leave the wrap: its angle is uncertain by one of 36 pieces, 3 %.
TEST(Capstan, SlidesAtTheRatioOfEulerAndEytelwein) {
  const Pull p = pull(3.0, 0.2);
  EXPECT_NEAR(p.ratio, std::exp(kFriction * kPi), 0.05 * std::exp(kFriction * kPi));
  EXPECT_GT(p.moved, 0.01);
}

}  // namespace
}  // namespace retiarius
