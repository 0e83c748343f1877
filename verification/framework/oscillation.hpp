// The exponent of a damped oscillation, measured from what an integrator made of it.
#pragma once

#include <complex>
#include <vector>

#include "retiarius/motion/spec.hpp"

namespace retiarius::verification {

// Least squares for samples y_n = Re(c z^n) of equal distance: z, |arg z| stride < pi, from the
// recurrence y_(n+m) = a y_n + b y_(n-m) with m = stride, best a quarter of a period.
std::complex<double> measured_factor(const std::vector<double>& samples, int stride);

// The exponent s (1/s) of the linear system which the method, stepping by h, turns into powers of
// z: implicit Euler has z = 1 / (1 - h s), trapezoid and midpoint z = (1 + h s/2) / (1 - h s/2). It
// takes the method's own warping of frequency and damping away, exactly.
std::complex<double> exponent_of(std::complex<double> factor, Method method, double h);

// Both: the exponent behind samples at every step. `period` is about that of the oscillation, s.
std::complex<double> measured_exponent(const std::vector<double>& samples, Method method, double h,
                                       double period);

}  // namespace retiarius::verification
