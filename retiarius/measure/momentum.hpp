// Momenta of net and free bodies, and how well a run keeps them.
#pragma once

#include <optional>
#include <vector>

#include "retiarius/base/archive.hpp"
#include "retiarius/bodies/body.hpp"
#include "retiarius/net/network.hpp"
#include "retiarius/state/state.hpp"

namespace retiarius {

// Fixed bodies have no part in any of these.
double total_mass(const Network& network, const std::vector<Body>& bodies);  // kg
Vec3 mass_center(const Network& network, const std::vector<Body>& bodies, const State& state);  // m

// Sum of m v, kg m/s.
Vec3 linear_momentum(const Network& network, const std::vector<Body>& bodies, const State& state);

// Sum of m (x - about) x v and of the bodies' own angular momenta, kg m2/s.
Vec3 angular_momentum(const Network& network, const std::vector<Body>& bodies, const State& state,
                      const Vec3& about);

// What drifts are compared with: sum m|v|, and sum m|x - c||v - vc| + sum |I w| with the present
// mass centre c and its velocity vc.
double linear_scale(const Network& network, const std::vector<Body>& bodies, const State& state);
double angular_scale(const Network& network, const std::vector<Body>& bodies, const State& state);

// The largest |momentum(t) - momentum(0) - outside impulse| since the last base, over the largest
// scale, both over the whole run.
class MomentumDrift {
 public:
  void rebase(const Vec3& momentum, const Vec3& impulse) { base_ = momentum - impulse; }
  void add(const Vec3& momentum, const Vec3& impulse, double scale);
  // Absent where nothing ever moved.
  std::optional<double> value() const;

  // For checkpoints; see base/archive.hpp.
  void transfer(Archive& archive) { archive(base_, largest_, scale_); }

 private:
  Vec3 base_ = Vec3::Zero();
  double largest_ = 0.0;
  double scale_ = 0.0;
};

}  // namespace retiarius
