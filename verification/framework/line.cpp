#include "verification/framework/line.hpp"

#include <cmath>

namespace retiarius::verification {

Material solid_thread(double young_modulus, double density, double radius, Bending bending) {
  const double area = kPi * radius * radius;
  Material m = plain_thread(young_modulus * area, density * area);
  m.young_modulus = young_modulus;
  m.density = density;
  m.radius = radius;
  m.bending = bending;
  if (bending != Bending::none) m.bending_stiffness = young_modulus * area * radius * radius / 4.0;
  return m;
}

Material plain_thread(double axial_stiffness, double line_density, double bending_stiffness,
                      Bending bending) {
  Material m;
  m.axial_stiffness = axial_stiffness;
  m.line_density = line_density;
  m.radius = 1e-3;
  m.bending_stiffness = bending_stiffness;
  m.bending = bending_stiffness > 0.0 ? bending : Bending::none;
  return m;
}

Network line_through(const std::vector<Vec3>& points, const Material& material) {
  Network net;
  net.materials = {material};
  net.design = net.initial = points;
  net.velocity.assign(points.size(), Vec3::Zero());
  net.mass.assign(points.size(), 0.0);
  net.threads.resize(1);
  Thread& thread = net.threads.front();
  const Index count = static_cast<Index>(points.size());
  for (Index k = 0; k < count; ++k) thread.nodes.push_back(k);
  for (Index k = 0; k + 1 < count; ++k) {
    const double rest = (points[k + 1] - points[k]).norm();
    net.segments.push_back({k, k + 1, rest, 0, 0});
    thread.segments.push_back(k);
    net.mass[k] += 0.5 * material.line_density * rest;
    net.mass[k + 1] += 0.5 * material.line_density * rest;
  }
  for (Index k = 0; k + 2 < count; ++k) {
    const double voronoi = 0.5 * (net.segments[k].rest_length + net.segments[k + 1].rest_length);
    net.joints.push_back({k, k + 1, k + 2, k, k + 1, voronoi, material.bending_stiffness});
  }
  return net;
}

Network straight_line(int segments, double length, const Material& material,
                      const Vec3& direction) {
  std::vector<Vec3> points;
  for (int k = 0; k <= segments; ++k) points.push_back(k * (length / segments) * direction);
  return line_through(points, material);
}

std::vector<Prescribed> held(const Network& network, const std::vector<Index>& nodes) {
  std::vector<Prescribed> result;
  for (Index i : nodes) result.push_back({i, network.initial[i], Vec3::Zero()});
  return result;
}

void advance(Simulation& simulation, double h, int count, const std::vector<Prescribed>& held,
             const std::function<void(int)>& each) {
  const double from = simulation.state().time;
  const PrescribedMotion motion = [&held](double) { return held; };
  for (int k = 1; k <= count; ++k) {
    const double end = from + k * h;
    while (simulation.state().time < end) simulation.advance(end, motion);
    if (each) each(k);
  }
}

IntegratorSpec with(Method method, double step, double tolerance) {
  IntegratorSpec spec;
  spec.method = method;
  spec.step = step;
  spec.tolerance = tolerance;
  return spec;
}

}  // namespace retiarius::verification
