// Bending at joints, with the bounded or the tangent curvature.
#pragma once

#include <vector>

#include "retiarius/forces/element_chunks.hpp"
#include "retiarius/forces/element_kernels.hpp"
#include "retiarius/net/network.hpp"
#include "retiarius/state/law.hpp"

namespace retiarius {

// Integrated curvature |kappa| squared as a function of c = cos(phi), and its derivatives. `gap` is
// 1 - c, which the caller knows better than the difference does: of a nearly straight joint that
// keeps the round-off eps of c, and thereby eps EI / lv of energy, more than a stiff, lightly
// loaded rod holds.
// Bounded (Huang et al. 2022, Eq. 7): 2 sin(phi/2), squared 2 (1 - c).
// Tangent (Eq. 8; Bergou et al. 2008): 2 tan(phi/2), squared 4 (1 - c) / (1 + c).
struct SquaredCurvature {
  double value, first, second;
};
SquaredCurvature squared_curvature(Bending kind, double c, double gap);

// Bending energy 1/2 (EI / lv) |kappa|^2 at each joint of a thread that is straight at rest. Where
// a segment is shorter than a fifth of its rest length, as only slack tension-only threads can be,
// its unit tangent is replaced by a shorter vector that vanishes smoothly with the segment.
class BendingLaw final : public Law {
 public:
  explicit BendingLaw(const Network& network);

  std::string_view name() const override { return "bending"; }
  void couple(BlockPattern& pattern) const override;
  void bind(const BlockPattern& pattern) override;
  double potential(const Step& step, const std::vector<Vec3>& y) const override;
  double assemble(const Step& step, const std::vector<Vec3>& y, Assembly& out) const override;

  double energy(const std::vector<Vec3>& x) const;  // J
  bool empty() const { return elements_.empty(); }

 private:
  struct Element {
    Index a, b, c;
    double rest1, rest2;  // rest lengths of its segments, m
    double factor;        // EI / (2 lv), J
    Bending kind;
  };
  double sum(const std::vector<Vec3>& y, const kernels::ElementSums& out) const;
  void assemble_definite(const std::vector<Vec3>& y, Assembly& out) const;

  std::vector<Element> elements_;  // those of the bounded curvature first
  // The same, as the kernels read them, with padding.
  std::vector<Index> a_, b_, c_, ab_, ac_, bc_;
  std::vector<double> rest1_, rest2_, factor_;
  ElementChunks chunks_;
  long bounded_ = 0;  // elements of the bounded curvature
};

// Curvature |kappa| / lv at each node, the largest of its joints, 1/m.
std::vector<double> node_curvatures(const Network& network, const std::vector<Vec3>& x);

}  // namespace retiarius
