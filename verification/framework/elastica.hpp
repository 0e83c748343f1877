// The planar elastic line in equilibrium, by integration of its differential equations with
// Runge-Kutta steps and shooting: it shares nothing with nets but the physics.
//
// Lengths are in units of the line's length L, forces in EI / L^2. With tangent angle a, curvature
// a', and the force (n_x, n_y) that the part beyond s exerts:
//   x' = (1 + e) cos a, y' = (1 + e) sin a, e = (n_x cos a + n_y sin a) / EA,
//   a'' = (1 + e) (n_x sin a - n_y cos a), n_y = lift + weight s.
#pragma once

#include <vector>

namespace retiarius::verification {

struct ElasticLine {
  double pull = 0.0;         // n_x
  double lift = 0.0;         // n_y at s = 0
  double weight = 0.0;       // w L^3 / EI, downwards along y
  double flexibility = 0.0;  // EI / (EA L^2); 0: inextensible
};

struct Station {
  double s = 0.0, x = 0.0, y = 0.0;
  double angle = 0.0, curvature = 0.0;
};

// From a station to s = `to`, in equal steps of fourth order; the first station is `from`. Where
// asked for it ends with the first station of negative curvature or of an angle beyond pi.
std::vector<Station> integrate(const ElasticLine& line, const Station& from, double to,
                               int steps = 1000, bool until_decided = false);

// A cantilever, horizontal at its clamp s = 0, with weight and a load at its tip (in EI / L^2).
// From the clamp in the origin to the tip.
std::vector<Station> cantilever(double weight, double tip_load, double flexibility = 0.0);

// A pinned line whose ends, at one height, are `span` < 1 apart; s from -1/2 to 1/2, lowest in its
// middle in the origin.
struct HangingLine {
  double pull = 0.0;          // horizontal force in the line, EI / L^2; negative: pushed
  double sag = 0.0;           // of its middle below its ends
  std::vector<Station> half;  // from the middle to the right end

  double span() const { return 2.0 * half.back().x; }
};

// Euler's elastica without weight, in closed form. k is the sine of half its end slope.
struct Elastica {
  double load = 0.0;        // P / P_critical
  double span = 0.0;        // end distance / L
  double deflection = 0.0;  // of the middle / L
};
Elastica elastica(double k);

// The heavy line; weight in EI / L^3, above 0.
HangingLine hanging_line(double span, double weight, double flexibility = 0.0);

// The heavy line whose ends are so far apart that nothing pulls or pushes them horizontally.
HangingLine free_hanging_line(double weight, double flexibility = 0.0);

// Pinned ends a distance L apart, load (in EI / L^2) at midspan, extensible. Deflection / L.
// Shooting loses itself where sqrt(pull) is far above 10: as the line becomes a cable.
double midpoint_deflection(double load, double flexibility);

}  // namespace retiarius::verification
