#include "retiarius/motion/integrator.hpp"

#include "retiarius/base/error.hpp"

namespace retiarius {

const char* to_string(Method method) {
  switch (method) {
    case Method::implicit_euler:
      return "implicit-euler";
    case Method::newmark:
      return "newmark";
    case Method::midpoint:
      return "midpoint";
    case Method::explicit_differences:
      return "explicit";
    case Method::static_solve:
      return "static";
  }
  return "";
}

std::string single_update_refusal(const IntegratorSpec& integrator, const ContactSpec& contact,
                                  bool bodies) {
  if (integrator.newton != Newton::single) return {};
  if (integrator.method != Method::implicit_euler)
    return "needs method = \"implicit-euler\", whose damping it relies on";
  if (bodies && contact.method != ContactMethod::none)
    return "needs contact.method = \"none\": contacts take more than one iteration to settle";
  return {};
}

Step make_step(Method method, const State& start, double h) {
  Step s;
  s.start = &start;
  s.h = h;
  switch (method) {
    case Method::implicit_euler:
      s.rate = 1.0 / h;
      s.inertia = 1.0 / (h * h);
      s.strain_rate = Step::StrainRate::backward;
      break;
    case Method::newmark:
      s.rate = 2.0 / h;
      s.carry = 1.0;
      s.inertia = 4.0 / (h * h);
      s.strain_rate = Step::StrainRate::trapezoid;
      break;
    case Method::midpoint:
      s.rate = 2.0 / h;
      s.inertia = 4.0 / (h * h);
      s.reach = 2.0;
      s.strain_rate = Step::StrainRate::midpoint;
      break;
    case Method::explicit_differences:
      throw Error("the explicit integrator solves for no stage");
    case Method::static_solve:
      // A pseudo-step of relaxation: inertia holds the net back, velocities do not count.
      s.rate = 0.0;
      s.inertia = 1.0 / (h * h);
      s.strain_rate = Step::StrainRate::none;
      break;
  }
  return s;
}

std::vector<Vec3> predicted_stage(Method method, const Step& step,
                                  const std::vector<Vec3>& acceleration) {
  std::vector<Vec3> y = first_guess(method, step);
  if (method == Method::newmark) {
    for (std::size_t i = 0; i < y.size(); ++i) y[i] += 0.25 * step.h * step.h * acceleration[i];
  }
  return y;
}

std::vector<Vec3> first_guess(Method method, const Step& step) {
  std::vector<Vec3> y = step.start->x;
  if (method == Method::static_solve) return y;
  const double time = step.h / step.reach;
  for (std::size_t i = 0; i < y.size(); ++i) y[i] += time * step.start->v[i];
  return y;
}

}  // namespace retiarius
