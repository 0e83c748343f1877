// What a mission says about time stepping ([integrator]): plain data.
#pragma once

namespace retiarius {

enum class Method {
  implicit_euler,
  newmark,
  midpoint,
  generalised_alpha,
  tr_bdf2,
  explicit_differences,
  static_solve,
  automatic  // explicit_differences where that is predicted to cost less; see motion/choice.hpp
};

// How a step's equations are solved: with a new factorisation for every iteration (direct), with
// one kept while it serves (reuse), or by conjugate gradients (pcg). automatic: pcg where the
// counts tell that it is quicker, else reuse where all threads carry compression, else direct.
enum class Solver { automatic, direct, reuse, pcg };

// How far the equations of an implicit step are solved: to the tolerance, or by one Newton update
// from where the velocities lead (linearly implicit: quicker, for real time, never converged).
enum class Newton { converged, single };

struct IntegratorSpec {
  Method method = Method::implicit_euler;
  double step = 0.01;  // h, s
  // Longest sub-step of the explicit integrator, s; 0: as long as is surely stable.
  double substep = 0.0;
  double tolerance = 1.0e-8;  // of Newton's iteration
  Solver solver = Solver::automatic;
  Newton newton = Newton::converged;
  double rho = 0.9;  // spectral radius of generalised alpha at infinite frequency, 0 to 1
  bool adaptive = false;
  // Local error that an adaptive step may make: root mean square over the nodes of the error of
  // position, over the median rest length.
  double accuracy = 1.0e-3;
  double min_step = 0.0;    // of adaptive steps, s; 0: a thousandth of `step`, their largest
  int max_iterations = 50;  // Newton iterations of one step before it is halved
  int max_halvings = 10;    // of a step before the run fails
};

}  // namespace retiarius
