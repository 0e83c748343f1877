// A network in MuJoCo: a free particle for each node, a spring for each segment.
#pragma once

#include <memory>
#include <vector>

#include <mujoco/mujoco.h>

#include "retiarius/net/network.hpp"

namespace retiarius::verification {

struct TwinOptions {
  Vec3 gravity = Vec3::Zero();  // m/s2
  double step = 1e-4;           // s
  double damping = 0.0;         // 1/s, force -damping m v on each node
  bool runge_kutta = false;     // of order 4; otherwise semi-implicit Euler, damping implicit
};

// Nodes are bodies on three slides with the network's masses; segments are spatial tendons between
// their centres with stiffness EA / l0 and spring length l0, which resist compression too. Held
// nodes are fixed to the world. Nothing collides.
class MujocoTwin {
 public:
  // Throws Error with MuJoCo's own message.
  MujocoTwin(const Network& network, const std::vector<Index>& held, const TwinOptions& options);

  void step();
  double time() const { return data_->time; }
  Vec3 position(Index node) const;
  double largest_speed() const;  // of all coordinates, m/s

 private:
  struct Free {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
    void operator()(mjData* data) const { mj_deleteData(data); }
  };

  std::vector<Vec3> start_;
  std::vector<int> coordinate_;  // of each node's first slide; -1 where it is held
  std::unique_ptr<mjModel, Free> model_;
  std::unique_ptr<mjData, Free> data_;
};

}  // namespace retiarius::verification
