// Roots, and what refinement of a mesh says: order of convergence and limit.
#pragma once

#include <functional>

#include <Eigen/Core>

namespace retiarius::verification {

// Root of f in [a, b], where it changes sign, to the last digit. Throws Error where it does not.
double bisect(const std::function<double(double)>& f, double a, double b);

// The same with fewer evaluations, to 1e-13 of the interval: regula falsi that halves the value of
// an end that stays (the Illinois rule).
double root(const std::function<double(double)>& f, double a, double b);

// Root of two equations in two unknowns near `start`: Newton's method with differences for
// derivatives and halved steps. Throws Error where it does not converge.
using Plane = std::function<Eigen::Vector2d(const Eigen::Vector2d&)>;
Eigen::Vector2d newton(const Plane& f, Eigen::Vector2d start);

// Observed order from the errors on a mesh and on one twice as fine.
double observed_order(double coarse_error, double fine_error);

// Limit of values whose error goes as h^order, from a mesh and one twice as fine (Richardson).
double extrapolated(double coarse, double fine, double order = 2.0);

}  // namespace retiarius::verification
