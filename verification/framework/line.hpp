// Threads and masses built by hand, for cases that no mission file describes.
#pragma once

#include <functional>
#include <vector>

#include "retiarius/motion/simulation.hpp"
#include "retiarius/net/network.hpp"

namespace retiarius::verification {

// For simulations without bodies, which must outlive them.
inline const std::vector<Body> kNoBodies;

// A solid round thread: EA, EI and line density from E (Pa), rho (kg/m3) and r0 (m).
Material solid_thread(double young_modulus, double density, double radius,
                      Bending bending = Bending::none);

// A thread of given stiffnesses: EA (N), line density (kg/m), EI (N m2; 0: it does not bend).
Material plain_thread(double axial_stiffness, double line_density, double bending_stiffness = 0.0,
                      Bending bending = Bending::bounded);

// One thread through the points, with joints where its material bends; rest lengths are the
// distances between neighbours. `hold` its positions by held().
Network line_through(const std::vector<Vec3>& points, const Material& material);

// Equal segments from the origin along `direction`.
Network straight_line(int segments, double length, const Material& material,
                      const Vec3& direction = Vec3::UnitX());

// The nodes of a list, held at their initial places.
std::vector<Prescribed> held(const Network& network, const std::vector<Index>& nodes);

// Advances to from + k h for k = 1 ... count, and calls each(k) after every one.
void advance(Simulation& simulation, double h, int count, const std::vector<Prescribed>& held,
             const std::function<void(int)>& each = {});

// Settings of an integrator.
IntegratorSpec with(Method method, double step = 0.01, double tolerance = 1e-8);

}  // namespace retiarius::verification
