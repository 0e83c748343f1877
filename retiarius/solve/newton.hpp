// Newton's iteration with line search on a problem that is the minimisation of a potential.
#pragma once

#include <string>

namespace retiarius {

// Whose blocks are projected to be positive semidefinite. Contact loses definiteness first and most
// often; the laws then keep their curvature.
enum class Projected { nothing, contact, everything };

// What Newton's iteration needs to know of a problem; the problem keeps the iterate.
class NewtonProblem {
 public:
  virtual ~NewtonProblem() = default;

  // Evaluates potential, gradient and Hessian at the present iterate and returns the potential.
  virtual double assemble(Projected projected) = 0;

  // Whether anything is in contact, so that to project contact alone may help.
  virtual bool has_contact() const { return false; }

  // The same without the Hessian; what was factorised last stays.
  virtual double evaluate() = 0;

  // Only the potential at the present iterate.
  virtual double potential() = 0;

  // Factorises the Hessian as assembled and computes the Newton direction; false where the matrix
  // is not positive definite.
  virtual bool find_direction() = 0;

  // Computes a direction from the present gradient with the matrix last factorised.
  virtual void reuse_direction() = 0;

  // Gradient (as last assembled) times direction: the potential's slope, negative for descent.
  virtual double slope() const = 0;

  // How far the problem can be evaluated along the direction: a fraction in (0, wanted]. Asked
  // before move() leads farther than the last answer.
  virtual double free_fraction(double wanted) { return wanted; }

  // Puts the iterate at base + fraction * direction; base is where the direction was computed.
  virtual void move(double fraction) = 0;

  // Keeps base and direction until restore_direction(), whatever directions are found meanwhile.
  virtual void keep_direction() = 0;
  virtual void restore_direction() = 0;

  // Puts in the gradient's place that of the quadratic model at the end of the whole direction:
  // nothing where the model is at rest, else the force that the constraint there needs by it.
  virtual void linearise() = 0;

  // Length of the direction, in the units of `NewtonSettings::step_tolerance`.
  virtual double direction_size() const = 0;

  // Residual over its scale: the iteration is converged where this is at most 1 and the last
  // step was short enough.
  virtual double residual_ratio() const = 0;

  // The largest force that others balance, N, with directions in m: positions that are rounded by
  // `NewtonSettings::round_off_step` blur the potential by their product.
  virtual double largest_force() const { return 0.0; }

  // Called when the iteration has converged to the loose or the full tolerance: may change the
  // problem (contacts, friction) and then returns true, and the iteration goes on.
  virtual bool revise(bool /*full*/) { return false; }
};

struct NewtonSettings {
  double step_tolerance = 0.0;  // on direction_size()
  // The loose convergence at which revise(false) is called: after a whole Newton step that short,
  // with a residual ratio that small. 0: never.
  double loose_step_tolerance = 0.0;
  double loose_residual_ratio = 0.0;
  // A step that short moves nothing that can be represented: the iteration then ends where the
  // residual ratio is at most round_off_ratio. 0: never.
  double round_off_step = 0.0;
  double round_off_ratio = 100.0;
  int max_iterations = 50;
  // After a step of a new factorisation that is at most so long the next one is taken from it too,
  // whatever their ratio. 0: never.
  double chord_step = 0.0;
  // Keep a factorisation while the steps it gives shrink fast enough (see minimise()).
  bool reuse = true;
};

struct NewtonResult {
  bool converged = false;
  int iterations = 0;  // linear solves
  int factorisations = 0;
  int projections = 0;  // times the Hessian had to be projected
  std::string failure;  // why it did not converge
};

// Close to the minimum the Hessian hardly changes, and a step with the last factorisation (the
// chord method) costs an evaluation and a solve instead of a factorisation besides. The iteration
// changes over to it where a Newton step is short, or at most a tenth of the one before, and back
// where a step with an old factorisation is more than three tenths of the one before, was shortened
// or does not descend. The test of convergence is the same for both.
NewtonResult minimise(NewtonProblem& problem, const NewtonSettings& settings);

// One whole Newton update without line search and without a look at where it leads (Baraff and
// Witkin 1998): the problem is left there with its gradient linearised. `converged` tells whether
// there was a direction to go.
NewtonResult update_once(NewtonProblem& problem);

}  // namespace retiarius
