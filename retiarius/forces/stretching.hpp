// Stretching of segments with Kelvin-Voigt material damping, bilateral or tension-only.
#pragma once

#include <vector>

#include "retiarius/forces/element_chunks.hpp"
#include "retiarius/forces/element_kernels.hpp"
#include "retiarius/net/network.hpp"
#include "retiarius/state/law.hpp"

namespace retiarius {

// Axial strain eps = l / l0 - 1 of the straight piece from a to b.
inline double axial_strain(const Vec3& a, const Vec3& b, double rest_length) {
  return (b - a).norm() / rest_length - 1.0;
}

// Stretching energy 1/2 EA l0 eps^2 (Huang et al. 2022; taut part only for tension-only threads),
// and inside a step the tension T = EA (eps + tau d(eps)/dt).
//
// With the strain rate linear in eps, T = c eps - d with c, d constant over the step, so that
// the incremental potential is a parabola in eps and its Hessian symmetric. Tension-only threads
// carry T = max(0, c eps - d). Their strain rate counts the taut part max(eps, 0) alone: with the
// slack part counted, T would jump at eps = 0 and the step would have no smooth minimum.
class Stretching final : public Law {
 public:
  explicit Stretching(const Network& network);

  std::string_view name() const override { return "stretching"; }
  void couple(BlockPattern& pattern) const override;
  void bind(const BlockPattern& pattern) override;
  void prepare(const Step& step) override;
  double potential(const Step& step, const std::vector<Vec3>& y) const override;
  double assemble(const Step& step, const std::vector<Vec3>& y, Assembly& out) const override;
  bool one_sided() const override { return one_sided_; }
  void relax(const Step& step, const Weights& weights, std::vector<Vec3>& y) const override;
  void foretell(const std::vector<Vec3>& y, const std::vector<Vec3>& next) override;
  bool hold(const std::vector<Vec3>& y, const Assembly& out) override;
  double awaken(const std::vector<Vec3>& y, const std::vector<Vec3>& next,
                const Assembly* out) override;
  void account(const Step& step, const std::vector<Vec3>& y, const std::vector<Vec3>& x1,
               Exchange& exchange) const override;

  // Tension of each segment at stage positions y of the step last prepared, viscous part
  // included, N.
  std::vector<double> tensions(const std::vector<Vec3>& y) const;
  void tensions(const std::vector<Vec3>& y, std::vector<double>& result) const;

  // Elastic energy at positions x, J.
  double energy(const std::vector<Vec3>& x) const;

 private:
  struct Element {
    Index a, b;
    double rest_length;      // m
    double axial_stiffness;  // EA, N
    double damping;          // tau, s
    bool compression;
    double strain;   // eps0 at the start, taut part for tension-only threads
    double viscous;  // viscous tension at the start, N (trapezoid only)
  };
  double tension(std::size_t element, double strain) const;
  static double mean_viscous(const Element& e, double end, double h);
  void take_for_taut(std::size_t element, const std::vector<Vec3>& y, double strain, double across,
                     const Assembly& out);
  double sum(const std::vector<Vec3>& y, bool definite, const kernels::ElementSums& out) const;

  std::vector<Element> elements_;
  // The same, as the kernels read them, with padding.
  std::vector<Index> a_, b_, slots_;
  std::vector<double> rest_, stiffness_, offset_, foretold_, bilateral_;
  std::vector<char> awake_;  // taken for taut at the place of the last direction
  ElementChunks chunks_;
  bool one_sided_ = false;
  bool trapezoid_ = false;
};

}  // namespace retiarius
