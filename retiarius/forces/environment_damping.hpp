// Environmental damping: a force -mu m v on every node.
#pragma once

#include <vector>

#include "retiarius/state/law.hpp"

namespace retiarius {

class EnvironmentDamping final : public Law {
 public:
  // mass: of each node, kg; mu: 1/s.
  EnvironmentDamping(std::vector<double> mass, double mu) : mass_(std::move(mass)), mu_(mu) {}

  std::string_view name() const override { return "environment damping"; }
  double potential(const Step& step, const std::vector<Vec3>& y) const override;
  double assemble(const Step& step, const std::vector<Vec3>& y, Assembly& out) const override;
  void account(const Step& step, const std::vector<Vec3>& y, const std::vector<Vec3>& x1,
               Exchange& exchange) const override;

 private:
  std::vector<double> mass_;
  double mu_;
};

}  // namespace retiarius
