// A net folded and shot with its threads in contact: no loop of it gets linked with another.
#include <algorithm>

#include <gtest/gtest.h>

#include "retiarius/contact/distance.hpp"
#include "retiarius/mission/reader.hpp"
#include "retiarius/mission/run.hpp"
#include "tests/contact/linking.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

constexpr double kSide = 0.8, kMesh = 0.2, kRadius = 2e-3;  // m

// Drawn together under gravity, then shot by the corners.
const char* const kMission = R"(
title = "Fold and deploy"
[net]
pattern = "square"
side = 0.8
mesh = 0.2
segments = 4
disturbance = 1.0e-3
[net.thread]
young_modulus = 1.0e7
density = 1000.0
radius = 0.002
bending = "bounded"
bending_stiffness = 1.0e-6
compression = false
material_damping = 1.0e-3
[net.corner_mass]
mass = 0.1
[integrator]
step = 0.005
max_iterations = 200
[contact]
method = "barrier"
self = true
thread_friction = 0.2
[[phase]]
kind = "fold"
grips = "lattice"
grip_spacing = 0.4
ratio = 0.15
duration = 0.8
until = "phase_time >= 1.0"
[phase.environment]
gravity = [0.0, 0.0, -9.81]
damping = 2.0
[[phase]]
kind = "shoot"
speed = 3.0
half_angle_deg = 45.0
until = "phase_time >= 0.4"
[output]
interval = 0.05
frame_interval = 0.05
)";

// The nodes round each mesh, in order.
std::vector<std::vector<Index>> meshes(const Network& net) {
  std::vector<std::vector<Index>> result;
  const int count = static_cast<int>(std::lround(kSide / kMesh));
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) {
      const Vec3 middle((i + 0.5) * kMesh - 0.5 * kSide, (j + 0.5) * kMesh - 0.5 * kSide, 0.0);
      std::vector<Index> loop;
      for (Index k = 0; k < net.node_count(); ++k) {
        const Vec3 off = net.design[static_cast<std::size_t>(k)] - middle;
        const double far = std::max(std::abs(off.x()), std::abs(off.y()));
        if (std::abs(far - 0.5 * kMesh) < 1e-9) loop.push_back(k);
      }
      std::sort(loop.begin(), loop.end(), [&](Index a, Index b) {
        const auto angle = [&](Index k) {
          const Vec3 off = net.design[static_cast<std::size_t>(k)] - middle;
          return std::atan2(off.y(), off.x());
        };
        return angle(a) < angle(b);
      });
      result.push_back(loop);
    }
  }
  return result;
}

// How two loops without common nodes are linked at most, over all pairs.
double most_linked(const std::vector<std::vector<Index>>& loops, const std::vector<Vec3>& x) {
  double most = 0.0;
  for (std::size_t a = 0; a < loops.size(); ++a) {
    for (std::size_t b = a + 1; b < loops.size(); ++b) {
      const bool apart = std::none_of(loops[a].begin(), loops[a].end(), [&](Index k) {
        return std::find(loops[b].begin(), loops[b].end(), k) != loops[b].end();
      });
      if (apart)
        most = std::max(most, std::abs(linking_number(places(x, loops[a]), places(x, loops[b]))));
    }
  }
  return most;
}

// The smallest distance of threads, over their thickness, but for neighbours along the net.
double closest(const Network& net, const std::vector<Vec3>& x) {
  double least = kInfinity;
  for (std::size_t i = 0; i < net.segments.size(); ++i) {
    for (std::size_t j = i + 1; j < net.segments.size(); ++j) {
      const Segment &s = net.segments[i], &t = net.segments[j];
      if (s.a == t.a || s.a == t.b || s.b == t.a || s.b == t.b) continue;
      least =
          std::min(least, distance(PairKind::edge_edge, {x[s.a], x[s.b], x[t.a], x[t.b]}).value);
    }
  }
  return least / (2.0 * kRadius);
}

struct Deployed {
  RunReport report;
  double linked = 0.0;         // most, at any output time
  double closest = kInfinity;  // over the thickness
  double bundle = kInfinity;   // smallest width of the net, m
  double width = 0.0;          // at the end, m
};

class Look final : public Observer {
 public:
  Look(const Network& net, Deployed& result) : net_(&net), loops_(meshes(net)), result_(&result) {}

  void progress(const State& s, Index, double) override {
    if (++steps_ % 5 != 0) return;
    result_->linked = std::max(result_->linked, most_linked(loops_, s.x));
    result_->closest = std::min(result_->closest, retiarius::closest(*net_, s.x));
    Vec3 low = s.x[0], high = s.x[0];
    for (const Vec3& x : s.x) {
      low = low.cwiseMin(x);
      high = high.cwiseMax(x);
    }
    result_->width = std::max(high.x() - low.x(), high.y() - low.y());
    result_->bundle = std::min(result_->bundle, result_->width);
  }

 private:
  const Network* net_;
  std::vector<std::vector<Index>> loops_;
  Deployed* result_;
  int steps_ = 0;
};

Deployed deploy(const std::vector<std::string>& overrides) {
  const Mission mission = parse_mission(kMission, "mission", ".", overrides);
  MissionModel model(mission);
  Deployed result;
  Look look(model.network, result);
  result.report = run_mission(mission, model, look);
  return result;
}

TEST(FoldedNet, DeploysWithoutALoopGettingLinked) {
  const Deployed d = deploy({});
  EXPECT_EQ(d.report.outcome, Outcome::finished) << d.report.reason;
  EXPECT_LT(d.linked, 1e-6);
  EXPECT_GT(d.closest, 1.0);
  EXPECT_LT(d.bundle, 0.3 * kSide);
  EXPECT_GT(d.width, 0.8 * kSide);
  RecordProperty("closest", std::to_string(d.closest));
  RecordProperty("bundle", std::to_string(d.bundle));
  RecordProperty("width", std::to_string(d.width));
}

// What contact prevents: without it threads pass through each other on the same way.
TEST(FoldedNet, GetsLinkedWithoutContactOfThreads) {
  const Deployed d = deploy({"contact.self=false"});
  EXPECT_EQ(d.report.outcome, Outcome::finished) << d.report.reason;
  EXPECT_GT(d.linked, 0.9);
  EXPECT_LT(d.closest, 0.5);
}

}  // namespace
}  // namespace retiarius
