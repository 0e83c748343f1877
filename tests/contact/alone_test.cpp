// The quick visit to contacts with one fixed body against the general one, in which contacts take
// turns: a second body that nothing reaches calls for that.
#include <algorithm>

#include <gtest/gtest.h>

#include "tests/contact/scene.hpp"
#include "tests/motion/flying_net.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

struct End {
  State state;
  int touching = 0, sticking = 0;
};

// A tension-only net thrown at a ball, which it drapes.
End drape(double friction, bool far_body, double time) {
  Network net = flying_net(Pattern::square, 2, false, 1e-5, 0.0);
  for (Vec3& v : net.velocity) v += Vec3(0.1, 0.05, 1.0);
  std::vector<Body> bodies{sphere(0.35, 0.0, {0.05, 0.02, 0.4}, BodyMotion::fixed)};
  if (far_body) bodies.push_back(sphere(0.1, 0.0, {0.0, 0.0, 50.0}, BodyMotion::fixed));
  Simulation sim(net, bodies, initial_state(net, bodies));
  sim.configure({{0, 0, 2.0}, 0.0}, with(Method::explicit_differences),
                {ContactMethod::modified_mass, friction});
  End end;
  run(sim, 0.002, static_cast<int>(std::lround(time / 0.002)), {}, [&](int) {
    end.touching = std::max(end.touching, static_cast<int>(sim.state().touches.size()));
    for (const Touch& t : sim.state().touches) end.sticking += t.sticks;
  });
  end.state = sim.state();
  return end;
}

TEST(ContactAlone, IsTheGeneralOneButForRounding) {
  for (const double friction : {0.0, 0.05, 0.5}) {
    const End quick = drape(friction, false, 0.1), slow = drape(friction, true, 0.1);
    ASSERT_GT(quick.touching, 4) << friction;
    EXPECT_EQ(quick.touching, slow.touching) << friction;
    if (friction > 0.1) {
      EXPECT_GT(quick.sticking, 0) << friction;
    }
    double apart = 0.0;
    for (std::size_t i = 0; i < quick.state.x.size(); ++i)
      apart = std::max(apart, (quick.state.x[i] - slow.state.x[i]).norm());
    EXPECT_LT(apart, 1e-9) << friction;
    const Account &a = quick.state.account, &b = slow.state.account;
    EXPECT_GT(a.impact_loss, 0.0);
    EXPECT_NEAR(a.impact_loss, b.impact_loss, 1e-7 * b.impact_loss) << friction;
    EXPECT_NEAR(a.friction_loss, b.friction_loss, 1e-6 * b.impact_loss) << friction;
    EXPECT_LT((a.outside_impulse - b.outside_impulse).norm(), 1e-8 * b.outside_impulse.norm());
  }
}

// In a step in which the net flies farther than a thread is thick, each node is found by the box
// that it leaves on the way, with a body that stays and with one that moves.
TEST(ContactAlone, NoNodeIsInsideAfterALongStep) {
  for (const BodyMotion motion : {BodyMotion::fixed, BodyMotion::free}) {
    Network net = flying_net(Pattern::square, 2, false, 1e-5, 0.0);
    for (Vec3& v : net.velocity) v += Vec3(0.1, 0.05, 1.0);
    const double mass = motion == BodyMotion::free ? 5.0 : 0.0;
    const std::vector<Body> ball{sphere(0.35, mass, {0.05, 0.02, 0.4}, motion)};
    Simulation sim(net, ball, initial_state(net, ball));
    sim.configure({{0, 0, 2.0}, 0.0}, with(Method::explicit_differences),
                  {ContactMethod::modified_mass, 0.05});
    double deepest = 0.0;
    std::size_t touching = 0;
    run(sim, 0.02, 8, {}, [&](int) {
      touching = std::max(touching, sim.state().touches.size());
      for (const Vec3& x : sim.state().x)
        deepest = std::max(deepest, 0.35 - (x - sim.state().bodies[0].position).norm());
    });
    EXPECT_GT(touching, 4u);
    EXPECT_EQ(deepest, 0.0);
  }
}

}  // namespace
}  // namespace retiarius
