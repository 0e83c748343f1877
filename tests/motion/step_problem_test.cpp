// The problem of one step, with a node that slides over a free body.
#include "retiarius/motion/step_problem.hpp"

#include <gtest/gtest.h>

#include "retiarius/motion/integrator.hpp"
#include "retiarius/motion/simulation.hpp"
#include "tests/contact/scene.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

// One contact that stays as it is; notes the reactions that it is asked to revise by.
class Unchanging final : public ContactResponse {
 public:
  std::vector<Constraint> contacts_now;
  std::vector<Vec3> reaction;

  void begin(const Step&, const std::vector<Vec3>&, const std::vector<BodyState>&,
             const std::vector<bool>&) override {}
  bool revise(const std::vector<Vec3>&, const std::vector<BodyState>&, const std::vector<Vec3>& by,
              bool) override {
    reaction = by;
    return false;
  }
  const std::vector<Constraint>& constraints() const override { return contacts_now; }
  void contacts(std::vector<SolvedContact>&) const override {}
};

// A node of 0.5 kg that runs into a light ball at its side; friction of up to 3 N sets it spinning.
class SlidingNode : public ::testing::Test {
 protected:
  SlidingNode() : problem_(net_.mass, bodies_, laws_, make_reference_solver()) {
    Constraint c;
    c.node = 0;
    c.body = 0;
    c.blocked = Vec3::UnitZ() * Vec3::UnitZ().transpose();
    c.target = net_.initial[0];
    c.lever = net_.initial[0];
    c.limit = 3.0;
    c.carried = net_.initial[0];
    c.smoothing = 1e-4;
    response_.contacts_now = {c};
    StepProblem::Start start;
    start.step = &step_;
    for (std::size_t i = 0; i < net_.mass.size(); ++i)
      start.predicted.push_back(state_.x[i] + step_.h * state_.v[i]);
    start.guess = state_.x;
    start.guess[0] += Vec3(1e-4, 2e-5, 0.0);
    start.prescribed = &nothing_;
    start.bodies = state_.bodies;
    start.contact = &response_;
    problem_.begin(std::move(start));
  }

  Network net_ = two_masses({0.12, 0.05, 0.16}, {0.1, 0.05, -0.1});
  std::vector<Body> bodies_{sphere(0.2, 0.1, {0, 0, 0})};
  State state_ = initial_state(net_, bodies_);
  Step step_ = make_step(Method::implicit_euler, state_, 1e-3);
  std::vector<Prescribed> nothing_;
  std::vector<std::unique_ptr<Law>> laws_;
  Unchanging response_;
  StepProblem problem_;
};

// Along Newton's direction d the slope g.d must change by d.H.d = -g.d, in which all second
// derivatives have their part: of the node, of the body, and of both.
TEST_F(SlidingNode, HasTheHessianOfItsGradient) {
  problem_.assemble(Projected::nothing);
  ASSERT_TRUE(problem_.find_direction());
  const double slope = problem_.slope(), e = 1e-4;
  ASSERT_LT(slope, 0.0);
  const auto slope_at = [&](double fraction) {
    problem_.move(fraction);
    problem_.evaluate();
    return problem_.slope();
  };
  EXPECT_NEAR((slope_at(e) - slope_at(-e)) / (2.0 * e) / -slope, 1.0, 1e-6);
}

// Reactions are foretold by the last direction, an old factorisation's as well: nearer to those at
// its end than what the direction before foretold.
TEST_F(SlidingNode, ForetellsReactionsByTheLastDirection) {
  problem_.assemble(Projected::nothing);
  ASSERT_TRUE(problem_.find_direction());
  problem_.move(1.0);
  problem_.evaluate();
  problem_.revise(false);
  const Vec3 before = response_.reaction[0];
  problem_.reuse_direction();
  problem_.move(1.0);
  problem_.evaluate();
  problem_.revise(false);
  const Vec3 foretold = response_.reaction[0], now = problem_.gradient()[0];
  EXPECT_GT(std::abs(before.z() - now.z()), 1e-6 * std::abs(now.z()));
  EXPECT_LT(std::abs(foretold.z() - now.z()), 0.5 * std::abs(before.z() - now.z()));
  problem_.revise(true);
  EXPECT_EQ(response_.reaction[0], now);
}

}  // namespace
}  // namespace retiarius
