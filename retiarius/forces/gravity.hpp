// Uniform gravity on the nodes.
#pragma once

#include <vector>

#include "retiarius/state/law.hpp"

namespace retiarius {

class Gravity final : public Law {
 public:
  // mass: of each node, kg; g: m/s2.
  Gravity(std::vector<double> mass, const Vec3& g) : mass_(std::move(mass)), g_(g) {}

  std::string_view name() const override { return "gravity"; }
  double potential(const Step& step, const std::vector<Vec3>& y) const override;
  double assemble(const Step& step, const std::vector<Vec3>& y, Assembly& out) const override;
  void account(const Step& step, const std::vector<Vec3>& y, const std::vector<Vec3>& x1,
               Exchange& exchange) const override;

 private:
  std::vector<double> mass_;
  Vec3 g_;
};

}  // namespace retiarius
