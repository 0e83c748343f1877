// The barrier's potential: all derivatives against finite differences.
#include "retiarius/contact/barrier.hpp"

#include <optional>

#include <Eigen/Eigenvalues>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "retiarius/base/error.hpp"
#include "retiarius/contact/barrier_function.hpp"
#include "retiarius/motion/integrator.hpp"
#include "tests/contact/scene.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

// Threads near a plane, a free sphere, box and capsule, and near each other; boxes near each other
// and near the plane: every pair kind at about half of the barrier's range.
class Scene {
 public:
  static constexpr double kRange = 2e-3;

  explicit Scene(double friction) : spec_(barriers(friction)) {
    spec_.gap = kRange;
    spec_.self = true;
    spec_.thread_friction = friction;
    spec_.stick_speed = 1e-2;  // full friction from 1e-4 m on
    add_bodies();
    add_threads();
    state_ = initial_state(net_, bodies_);
    step_.start = &state_;
    step_.h = 1e-2;
    for (std::size_t i = 0; i < net_.mass.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        pattern_.couple(static_cast<Index>(i), static_cast<Index>(j));
    pattern_.finish();
    contact_.emplace(net_, bodies_, spec_, step_.h);
    contact_->begin(step_, search_time_);
  }

  Eigen::Index unknowns() const {
    return static_cast<Eigen::Index>(3 * net_.mass.size() + 6 * bodies_.size());
  }

  struct Result {
    double value = 0.0;
    Eigen::VectorXd gradient;
    Eigen::MatrixXd hessian;
  };

  // Everything displaced by u: nodes, then each body's translation and rotation vector.
  Result evaluate(const Eigen::VectorXd& u, bool hessian = false, bool definite = false) {
    const std::size_t n = net_.mass.size(), count = bodies_.size();
    const auto [x, turns, poses] = places(u);
    std::vector<Vec3> gradient(n, Vec3::Zero());
    std::vector<Vec6> body_gradient(count, Vec6::Zero());
    BlockMatrix matrix;
    matrix.reset(pattern_);
    std::vector<ContactAssembly::NodeBody> node_body;
    std::vector<ContactAssembly::BodyBody> body_body;
    ContactAssembly out;
    out.gradient = &gradient;
    out.body_gradient = &body_gradient;
    out.definite = definite;
    if (hessian) {
      out.hessian = &matrix;
      out.node_body = &node_body;
      out.body_body = &body_body;
    }
    Result result;
    const double value = contact_->evaluate({&x, &poses, &turns}, nullptr);
    result.value = contact_->evaluate({&x, &poses, &turns}, &out);
    EXPECT_EQ(result.value, value);
    result.gradient = Eigen::VectorXd::Zero(unknowns());
    for (std::size_t i = 0; i < n; ++i) result.gradient.segment<3>(at(i)) = gradient[i];
    for (std::size_t b = 0; b < count; ++b)
      result.gradient.segment<6>(body_at(b)) = body_gradient[b];
    if (hessian) result.hessian = dense(matrix, node_body, body_body);
    return result;
  }

  // A direction from u to v.
  void note_direction(const Eigen::VectorXd& u, const Eigen::VectorXd& v) {
    const auto [x, turns, poses] = places(u);
    const auto [y, turns_there, poses_there] = places(v);
    contact_->note_direction({&x, &poses, &turns}, {&y, &poses_there, &turns_there});
  }

  // The Hessian with each barrier's own curvature: of a direction that leads nowhere.
  Eigen::MatrixXd plain_hessian(const Eigen::VectorXd& u, bool definite = false) {
    evaluate(u, true);
    note_direction(u, u);
    return evaluate(u, true, definite).hessian;
  }

  // With nodes 14 and 15, the upper of the crossed threads, higher by so much, m.
  std::vector<std::pair<Index, Index>> couplings_with_raised(double height) {
    std::vector<Vec3> x = state_.x;
    for (std::size_t i : {14u, 15u}) x[i].z() += height;
    const std::vector<Vec3> turns(bodies_.size(), Vec3::Zero());
    return contact_->couplings({&x, &state_.bodies, &turns}, BarrierContact::Coupled::in_range);
  }
  std::vector<PairContact> contacts() {
    const std::vector<Vec3> turns(bodies_.size(), Vec3::Zero());
    std::vector<PairContact> result;
    contact_->contacts({&state_.x, &state_.bodies, &turns}, result);
    return result;
  }
  bool is_fixed(Eigen::Index unknown) const {
    const auto first = static_cast<Eigen::Index>(3 * net_.mass.size());
    return unknown >= first && bodies_[static_cast<std::size_t>((unknown - first) / 6)].fixed;
  }

 private:
  struct Places {
    std::vector<Vec3> x, turns;
    std::vector<BodyState> poses;
  };
  Places places(const Eigen::VectorXd& u) const {
    const std::size_t count = bodies_.size();
    Places p{state_.x, std::vector<Vec3>(count), state_.bodies};
    for (std::size_t i = 0; i < p.x.size(); ++i) p.x[i] += u.segment<3>(at(i));
    for (std::size_t b = 0; b < count; ++b) {
      p.turns[b] = u.segment<3>(body_at(b) + 3);
      p.poses[b] = displaced(p.poses[b], u.segment<3>(body_at(b)), p.turns[b]);
    }
    return p;
  }

  static Eigen::Index at(std::size_t node) { return static_cast<Eigen::Index>(3 * node); }
  Eigen::Index body_at(std::size_t body) const {
    return static_cast<Eigen::Index>(3 * net_.mass.size() + 6 * body);
  }

  void add_bodies() {
    bodies_ = {fixed_plane(), sphere(0.1, 2.0, {1, 0, 0.5}),
               box({0.2, 0.3, 0.1}, 3.0, {2, 0, 0.05 + 0.5 * kRange})};
    bodies_.push_back(box({0.1, 0.1, 0.1}, 1.0, {2.02, 0.01, 0.15 + 1.0 * kRange}));
    BodySpec capsule;
    capsule.shape = ShapeKind::capsule;
    capsule.radius = 0.05;
    capsule.length = 0.2;
    capsule.mass = 1.5;
    capsule.position = {3, 0, 0.5};
    bodies_.push_back(build_body(capsule, ""));
  }

  void add_threads() {
    const double off = kRadius + 0.5 * kRange;
    net_.materials = {thread_material(100.0, 1e-2, kRadius)};
    add({{0.0, 0, off}, {0.1, 0.01, off + 2e-4}});            // on the plane
    add({{0.96, -0.1, 0.6 + off}, {1.05, 0.12, 0.6 + off}});  // across the sphere
    add({{1, 0.1 + off, 0.48}, {1, 0.2, 0.49}});              // its end on the sphere
    add({{2.1 + off, 0.0, 0.04}, {2.2, 0.0, 0.05}});          // its end on the box's face
    const double diagonal = off / std::sqrt(2.0);             // across the box's edge
    add({{2.06 + diagonal, -0.02, 0.25 + diagonal}, {2.16 + diagonal, 0.03, 0.15 + diagonal}});
    add({{2.95, 0.05 + off, 0.51}, {3.08, 0.05 + off, 0.48}});  // across the capsule
    add({{5, -0.1, 0.5}, {5, 0.1, 0.51}});                      // two threads across each other
    add({{4.93, 0.01, 0.506 + 2 * off - 0.5 * kRange},
         {5.1, -0.02, 0.504 + 2 * off - 0.5 * kRange}});
    add({{6, 0, 0.5}, {6.2, 0, 0.5}});  // two nearly parallel ones
    add({{6.01, 1e-3, 0.5 + off + kRadius}, {6.21, -1e-3, 0.5 + off + kRadius}});
  }

  void add(const std::vector<Vec3>& points) {
    std::vector<Index> nodes;
    for (const Vec3& p : points) {
      nodes.push_back(net_.node_count());
      net_.design.push_back(p);
      net_.mass.push_back(1e-3);
    }
    net_.initial = net_.design;
    net_.velocity.assign(net_.design.size(), Vec3::Zero());
    add_thread(net_, nodes, {(points[1] - points[0]).norm()}, 0.0);
  }

  Eigen::MatrixXd dense(const BlockMatrix& matrix,
                        const std::vector<ContactAssembly::NodeBody>& node_body,
                        const std::vector<ContactAssembly::BodyBody>& body_body) const {
    Eigen::MatrixXd h = Eigen::MatrixXd::Zero(unknowns(), unknowns());
    for (std::size_t i = 0; i < net_.mass.size(); ++i) {
      h.block<3, 3>(at(i), at(i)) = matrix.diagonal[i];
      for (std::size_t j = 0; j < i; ++j) {
        const Mat3& block = matrix.below[static_cast<std::size_t>(
            pattern_.slot(static_cast<Index>(i), static_cast<Index>(j)))];
        h.block<3, 3>(at(i), at(j)) = block;
        h.block<3, 3>(at(j), at(i)) = block.transpose();
      }
    }
    for (const auto& e : node_body) {
      const Eigen::Index i = at(static_cast<std::size_t>(e.node));
      const Eigen::Index b = body_at(static_cast<std::size_t>(e.body));
      h.block<3, 6>(i, b) += e.block;
      h.block<6, 3>(b, i) += e.block.transpose();
    }
    for (const auto& e : body_body) {
      const Eigen::Index a = body_at(static_cast<std::size_t>(e.first));
      const Eigen::Index b = body_at(static_cast<std::size_t>(e.second));
      h.block<6, 6>(a, b) += e.block;
      if (a != b) h.block<6, 6>(b, a) += e.block.transpose();
    }
    return h;
  }

  ContactSpec spec_;
  std::vector<Body> bodies_;
  Network net_;
  State state_;
  Step step_;
  BlockPattern pattern_{20};
  std::optional<BarrierContact> contact_;
  double search_time_ = 0.0;
};

// A displacement that slips everything by some slip, in [-1, 1] times `size`.
Eigen::VectorXd displacement(const Scene& scene, double size) {
  Eigen::VectorXd u(scene.unknowns());
  for (Eigen::Index k = 0; k < u.size(); ++k)
    u[k] = scene.is_fixed(k) ? 0.0 : size * std::sin(1.7 * static_cast<double>(k) + 0.3);
  return u;
}

TEST(BarrierScene, HoldsEveryKindOfPair) {
  Scene scene(0.3);
  std::vector<int> kinds(5, 0);
  int threads = 0, bodies = 0;
  for (const PairContact& c : scene.contacts()) {
    ++kinds[static_cast<std::size_t>(c.pair.kind)];
    threads += c.pair.first_owner == kNet && c.pair.second_owner == kNet;
    bodies += c.pair.first_owner != kNet && c.pair.second_owner != kNet;
    EXPECT_GT(c.gap, 0.0);
    EXPECT_LT(c.gap, Scene::kRange);
  }
  EXPECT_GT(kinds[static_cast<std::size_t>(PairKind::point_edge)], 0);
  EXPECT_GT(kinds[static_cast<std::size_t>(PairKind::point_triangle)], 0);
  EXPECT_GT(kinds[static_cast<std::size_t>(PairKind::edge_edge)], 0);
  EXPECT_GT(kinds[static_cast<std::size_t>(PairKind::point_plane)], 0);
  EXPECT_EQ(threads, 2);
  EXPECT_GT(bodies, 4);
}

// Every contact is a pair of forces: no sum, no moment.
TEST(BarrierScene, ForcesStandInExactPairs) {
  Scene scene(0.3);
  for (const PairContact& c : scene.contacts()) {
    Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
    const bool plane = c.pair.kind == PairKind::point_plane;
    if (plane) continue;  // the plane is fixed and has no points
    double scale = 0.0;
    for (int i = 0; i < point_count(c.pair.kind); ++i) {
      sum += c.point_force[i];
      moment += (c.place[i] - c.place[0]).cross(c.point_force[i]);
      scale = std::max(scale, c.point_force[i].norm());
    }
    EXPECT_LT(sum.norm(), 1e-14 * scale);
    EXPECT_LT(moment.norm(), 1e-14 * scale);
  }
}

void expect_gradient(Scene& scene, const Eigen::VectorXd& u, double friction) {
  const Scene::Result here = scene.evaluate(u);
  const double e = 2e-8, scale = here.gradient.cwiseAbs().maxCoeff();
  ASSERT_GT(scale, 0.0);
  for (Eigen::Index k = 0; k < u.size(); ++k) {
    if (scene.is_fixed(k)) continue;
    const Eigen::VectorXd d = e * Eigen::VectorXd::Unit(u.size(), k);
    const double slope = (scene.evaluate(u + d).value - scene.evaluate(u - d).value) / (2 * e);
    EXPECT_NEAR(here.gradient[k], slope, 1e-6 * scale) << k << " friction " << friction;
  }
}

TEST(BarrierScene, GradientIsThatOfThePotential) {
  for (double friction : {0.0, 0.3}) {
    Scene scene(friction);
    expect_gradient(scene, displacement(scene, 0.0), friction);
    expect_gradient(scene, displacement(scene, 2e-5), friction);  // sticks
    expect_gradient(scene, displacement(scene, 4e-4), friction);  // slips
  }
}

// Bodies' second derivatives are wanted where they have not turned from their free motion. Those of
// friction bend sharply at no slip, where finite differences do not show them.
TEST(BarrierScene, HessianIsThatOfThePotential) {
  for (double friction : {0.0, 0.3}) {
    Scene scene(friction);
    for (double size : {friction == 0.0 ? 0.0 : 5e-6, 2e-5, 4e-4}) {
      Eigen::VectorXd u = displacement(scene, size);
      for (Eigen::Index b = 0; b < 5; ++b) u.segment<3>(60 + 6 * b + 3).setZero();
      const Eigen::MatrixXd here = scene.plain_hessian(u);
      const double e = 2e-8, scale = here.cwiseAbs().maxCoeff();
      for (Eigen::Index k = 0; k < u.size(); ++k) {
        if (scene.is_fixed(k)) continue;
        const Eigen::VectorXd d = e * Eigen::VectorXd::Unit(u.size(), k);
        const Eigen::VectorXd column =
            (scene.evaluate(u + d).gradient - scene.evaluate(u - d).gradient) / (2 * e);
        EXPECT_LT((here.col(k) - column).cwiseAbs().maxCoeff(), 2e-6 * scale)
            << k << " friction " << friction << " size " << size;
      }
    }
  }
}

// Where slips have turned against those noted, friction's Hessian has that of the quadratic above
// it: more along the slips, and the same gradient. Where they go on it stays as it is.
TEST(BarrierScene, HessianOfFrictionIsHigherWhereSlipsTurnedBack) {
  Scene scene(0.3);
  const Eigen::VectorXd u = displacement(scene, 4e-4);
  const Eigen::MatrixXd plain = scene.plain_hessian(u);
  const Scene::Result onward = scene.evaluate(u, true);
  EXPECT_LE((onward.hessian - plain).norm(), 1e-10 * plain.norm());
  scene.note_direction(-u, -u);  // a way of no length from where slips are the opposite
  const Scene::Result turned = scene.evaluate(u, true);
  EXPECT_EQ(turned.value, onward.value);
  EXPECT_EQ(turned.gradient, onward.gradient);
  const Eigen::VectorXd added =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(turned.hessian - plain).eigenvalues();
  EXPECT_GT(added.minCoeff(), -1e-10 * plain.norm());
  EXPECT_GT(added.maxCoeff(), 0.05 * plain.norm());
}

// The next Hessian leads to the gap that belongs to the force at a direction's end, as the last one
// foretells it; the gradient stays that of the potential.
TEST(Barrier, HessianLeadsToTheGapOfTheForetoldForce) {
  const double range = 2e-4, gap = 0.05 * range, way = 0.8 * gap;
  const std::vector<Body> bodies = {fixed_plane()};
  const Network net = two_masses({0, 0, kRadius + gap});
  const State state = initial_state(net, bodies);
  Step step;
  step.start = &state;
  step.h = 1e-2;
  ContactSpec spec = barriers();
  spec.gap = range;
  BarrierContact contact(net, bodies, spec, step.h);
  double search_time = 0.0;
  contact.begin(step, search_time);
  BlockPattern pattern(2);
  pattern.couple(1, 0);
  pattern.finish();
  const std::vector<Vec3> turns(1, Vec3::Zero());
  const ContactPlaces here{&state.x, &state.bodies, &turns};
  std::vector<Vec3> gradient;
  const auto curvature = [&] {
    gradient.assign(2, Vec3::Zero());
    std::vector<Vec6> body_gradient(1, Vec6::Zero());
    std::vector<ContactAssembly::NodeBody> node_body;
    std::vector<ContactAssembly::BodyBody> body_body;
    BlockMatrix matrix;
    matrix.reset(pattern);
    ContactAssembly out;
    out.gradient = &gradient;
    out.body_gradient = &body_gradient;
    out.hessian = &matrix;
    out.node_body = &node_body;
    out.body_body = &body_body;
    contact.evaluate(here, &out);
    return matrix.diagonal[0](2, 2);
  };
  const Jet own = barrier(gap, range);
  const double plain = curvature(), stiffness = plain / own.second;
  EXPECT_NEAR(gradient[0].z(), stiffness * own.first, 1e-9 * plain * gap);
  std::vector<Vec3> up = state.x;
  up[0].z() += way;
  contact.note_direction(here, {&up, &state.bodies, &turns});
  const Jet foretold = foretold_barrier(gap, range, -own.first - own.second * way);
  EXPECT_NEAR(curvature(), stiffness * foretold.second, 1e-9 * plain);
  EXPECT_LT(foretold.second, 0.9 * own.second);
  EXPECT_NEAR(gradient[0].z(), stiffness * own.first, 1e-9 * plain * gap);
}

TEST(BarrierScene, DefiniteHessianHasNoNegativeEigenvalue) {
  Scene scene(0.3);
  const Scene::Result here = scene.evaluate(displacement(scene, 4e-4), true, true);
  const Eigen::VectorXd values =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(here.hessian).eigenvalues();
  EXPECT_GT(values.minCoeff(), -1e-12 * values.maxCoeff());
  EXPECT_GT(values.maxCoeff(), 0.0);
}

// It lacks the negative curvature of pairs alone: without that part nothing keeps Newton's steps
// from sliding along one contact into the next.
TEST(BarrierScene, DefiniteHessianLacksNothingButNegativeCurvature) {
  Scene scene(0.0);
  const Eigen::VectorXd u = displacement(scene, 2e-5);
  const Eigen::MatrixXd full = scene.plain_hessian(u).topLeftCorner(60, 60);
  const Eigen::MatrixXd definite = scene.plain_hessian(u, true).topLeftCorner(60, 60);
  const Eigen::VectorXd added =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(definite - full).eigenvalues();
  EXPECT_GT(added.minCoeff(), -1e-10 * definite.norm());
  EXPECT_GT(added.maxCoeff(), 1e-6 * definite.norm());
}

// Friction of a round acts on threads that have parted since: they stay coupled.
TEST(BarrierScene, CouplesThreadsThatFrictionJoinsThoughTheyParted) {
  using Pairs = std::vector<std::pair<Index, Index>>;
  for (double friction : {0.0, 0.3}) {
    Scene scene(friction);
    const Pairs crossed{{12, 14}, {12, 15}, {13, 14}, {13, 15}},
        along{{16, 18}, {16, 19}, {17, 18}, {17, 19}};
    Pairs both = crossed;
    both.insert(both.end(), along.begin(), along.end());
    EXPECT_EQ(scene.couplings_with_raised(0.0), both);
    EXPECT_EQ(scene.couplings_with_raised(1.0), friction > 0.0 ? both : along);
  }
}

std::string refusal(const Network& net, const std::vector<Body>& bodies, bool self) {
  Simulation sim(net, bodies, initial_state(net, bodies));
  ContactSpec contact = barriers();
  contact.self = self;
  sim.configure({}, with(Method::implicit_euler), contact);
  try {
    sim.advance(1e-3, {});
  } catch (const RunError& e) {
    return e.what();
  }
  return "";
}

TEST(BarrierStart, RefusesWhatInterpenetratesByName) {
  using ::testing::HasSubstr;
  const std::string on_plane = refusal(two_masses({0, 0, 0.5 * kRadius}), {fixed_plane()}, false);
  EXPECT_THAT(on_plane, HasSubstr("node 0"));
  EXPECT_THAT(on_plane, HasSubstr("by 0.0005 m"));
  EXPECT_THAT(on_plane, HasSubstr("plane"));
  Network crossed = two_masses({0, 0, 0});
  crossed.design.insert(crossed.design.end(), {Vec3(-0.1, 0, 0.001), Vec3(0.1, 0, 0.001)});
  crossed.initial = crossed.design;
  crossed.velocity.assign(4, Vec3::Zero());
  crossed.mass.resize(4, 0.5);
  add_thread(crossed, {2, 3}, {0.2}, 0.0);
  EXPECT_THAT(refusal(crossed, {}, true),
              HasSubstr("segment 0 (nodes 0 and 1) and segment 1 (nodes 2 and 3) by 0.001 m"));
  EXPECT_EQ(refusal(crossed, {}, false), "");
}

}  // namespace
}  // namespace retiarius
