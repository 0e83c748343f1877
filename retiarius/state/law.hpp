// The face of every law of force.
#pragma once

#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "retiarius/base/block_matrix.hpp"
#include "retiarius/base/vec.hpp"
#include "retiarius/state/step.hpp"

namespace retiarius {

// What a law writes into. The gradient is that of the incremental potential with respect to the
// stage positions, i.e. minus the force; blocks are its second derivatives.
struct Assembly {
  std::vector<Vec3>* gradient = nullptr;  // N, one row a node
  BlockMatrix* hessian = nullptr;         // N/m; null: not wanted
  // True: each element's block is projected to the nearest positive semidefinite one.
  bool definite = false;
};

// What a law takes out of the mechanical energy, or brings in from outside, over an accepted step.
struct Exchange {
  double material_loss = 0.0;                   // J
  double environment_loss = 0.0;                // J
  Vec3 outside_impulse = Vec3::Zero();          // N s
  Vec3 outside_angular_impulse = Vec3::Zero();  // about the origin, N m s
};

// Of each node; what is held does not move.
struct Weights {
  const std::vector<double>* mass = nullptr;  // kg
  const std::vector<bool>* held = nullptr;
};

class Law {
 public:
  virtual ~Law() = default;
  virtual std::string_view name() const = 0;

  // Adds the pairs of nodes that the law couples.
  virtual void couple(BlockPattern&) const {}
  // Called once the pattern is complete (again when it has grown): look up one's slots here.
  virtual void bind(const BlockPattern&) {}
  // Called at the start of each attempted step: what depends on the start alone is computed here.
  virtual void prepare(const Step&) {}

  // The incremental potential at stage positions y, J: its gradient is the law's contribution to
  // the residual. Infinity where y is inadmissible.
  virtual double potential(const Step&, const std::vector<Vec3>& y) const = 0;

  // Adds gradient and, where wanted, Hessian of the incremental potential; returns the potential.
  virtual double assemble(const Step&, const std::vector<Vec3>& y, Assembly& out) const = 0;

  // Whether elements act on one side of a place only, as threads that bear no compression.
  virtual bool one_sided() const { return false; }

  // Moves nodes of a first guess `y` that strain the law's elements far beyond the step's start.
  virtual void relax(const Step&, const Weights&, std::vector<Vec3>& /*y*/) const {}

  // What follows is for one-sided laws, and helps Newton's iteration to foresee what acts at its
  // end. It changes the Hessian and directions, never potential or gradient.
  //
  // Notes the force that each element has at `next` as far as its linearisation at y tells, with
  // those awake that were held or awakened at y. Forgotten with the next prepare().
  virtual void foretell(const std::vector<Vec3>& /*y*/, const std::vector<Vec3>& /*next*/) {}

  // Adds what elements that do not act at y, but do by what was foretold, would add to gradient and
  // Hessian at y if they acted there. Returns whether there are any.
  virtual bool hold(const std::vector<Vec3>& /*y*/, const Assembly& /*out*/) { return false; }

  // The potential at `next` of those elements that act there but neither act at y nor are held, J.
  // Where `out` is given, adds what these would add to gradient and Hessian at y if they acted
  // there already.
  virtual double awaken(const std::vector<Vec3>& /*y*/, const std::vector<Vec3>& /*next*/,
                        const Assembly* /*out*/) {
    return 0.0;
  }

  // Adds what the step from its start through stage y to positions x1 exchanged.
  virtual void account(const Step&, const std::vector<Vec3>& /*y*/, const std::vector<Vec3>& /*x1*/,
                       Exchange&) const {}
};

// Puts a law of one's own in place of one that a simulation has made, for instance one that scales
// or watches it. The law given must live as long as the one returned, which may own it.
using LawWrapper = std::function<std::unique_ptr<Law>(std::unique_ptr<Law>)>;

}  // namespace retiarius
