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
    case Method::generalised_alpha:
      return "generalised-alpha";
    case Method::tr_bdf2:
      return "tr-bdf2";
    case Method::static_solve:
      return "static";
    case Method::automatic:
      return "auto";
  }
  return "";
}

std::string single_update_refusal(const IntegratorSpec& integrator, const ContactSpec& contact,
                                  bool bodies) {
  if (integrator.newton != Newton::single) return {};
  if (integrator.method != Method::implicit_euler && integrator.method != Method::automatic)
    return "needs method = \"implicit-euler\", whose damping it relies on";
  if (integrator.solver == Solver::pcg)
    return "needs a direct solver: what conjugate gradients leave would not be made up for";
  if (integrator.adaptive)
    return "needs adaptive = false: its error would hide in the estimate of the local one";
  if ((bodies && contact.method != ContactMethod::none) || contact.self)
    return "needs contact.method = \"none\": contacts take more than one iteration to settle";
  return {};
}

GeneralisedAlpha generalised_alpha(double rho) {
  GeneralisedAlpha a{};
  a.alpha_m = (2.0 * rho - 1.0) / (rho + 1.0);
  a.alpha_f = rho / (rho + 1.0);
  a.gamma = 0.5 - a.alpha_m + a.alpha_f;
  a.beta = 0.25 * (0.5 + a.gamma) * (0.5 + a.gamma);
  return a;
}

namespace {

void set_generalised_alpha(const GeneralisedAlpha& a, Step& s) {
  const double stage = 1.0 - a.alpha_f;  // share of the way that the stage has gone
  s.rate = a.gamma / (a.beta * s.h);
  s.carry = -a.alpha_f - stage * (1.0 - a.gamma / a.beta);
  s.inertia = (1.0 - a.alpha_m) / (a.beta * s.h * s.h * stage);
  s.reach = 1.0 / stage;
  s.strain_rate = Step::StrainRate::predicted;
}

}  // namespace

Step make_step(Method method, const State& start, double h, double rho) {
  Step s;
  s.start = &start;
  s.h = method == Method::tr_bdf2 ? tr_bdf2::kGamma * h : h;
  switch (method) {
    case Method::implicit_euler:
      s.rate = 1.0 / h;
      s.inertia = 1.0 / (h * h);
      s.strain_rate = Step::StrainRate::backward;
      break;
    case Method::newmark:
    case Method::tr_bdf2:
      s.rate = 2.0 / s.h;
      s.carry = 1.0;
      s.inertia = 4.0 / (s.h * s.h);
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
    case Method::automatic:
      throw Error("the integrator is still to be chosen");
    case Method::generalised_alpha:
      set_generalised_alpha(generalised_alpha(rho), s);
      break;
    case Method::static_solve:
      // A pseudo-step of relaxation: inertia holds the net back, velocities do not count.
      s.rate = 0.0;
      s.inertia = 1.0 / (h * h);
      s.strain_rate = Step::StrainRate::none;
      break;
  }
  return s;
}

std::vector<Vec3> alpha_drift(double rho, const Step& step, const std::vector<Vec3>& acceleration) {
  const GeneralisedAlpha a = generalised_alpha(rho);
  const double weight = (1.0 - a.alpha_f) * (1.0 - 0.5 * a.gamma / a.beta) * step.h;
  std::vector<Vec3> drift = acceleration;
  for (Vec3& d : drift) d *= weight;
  return drift;
}

std::vector<Vec3> predicted_stage(Method method, const Step& step,
                                  const std::vector<Vec3>& acceleration, double rho,
                                  std::vector<Vec3> room) {
  std::vector<Vec3> y = first_guess(method, step, std::move(room));
  double share = 0.0;  // of h^2 a0
  if (method == Method::newmark || method == Method::tr_bdf2) share = 0.25;
  if (method == Method::generalised_alpha) {
    const GeneralisedAlpha a = generalised_alpha(rho);
    share = (1.0 - a.alpha_f) * (0.5 - a.beta - a.alpha_m * a.beta / (1.0 - a.alpha_m));
  }
  if (share == 0.0) return y;
  for (std::size_t i = 0; i < y.size(); ++i) y[i] += share * step.h * step.h * acceleration[i];
  return y;
}

std::vector<Vec3> first_guess(Method method, const Step& step, std::vector<Vec3> room) {
  std::vector<Vec3> y = std::move(room);
  y = step.start->x;
  if (method == Method::static_solve) return y;
  const double time = step.h / step.reach;
  for (std::size_t i = 0; i < y.size(); ++i) y[i] += time * step.start->v[i];
  return y;
}

void make_bdf2_step(const State& start, double whole, const std::vector<Vec3>& change,
                    const std::vector<Vec3>& moved, Bdf2Step& out) {
  using tr_bdf2::kGamma;
  using tr_bdf2::kRepeat;
  Step& s = out.step;
  s.start = &start;
  s.h = (1.0 - kGamma) * whole;
  s.rate = 2.0 / (kGamma * whole);
  s.inertia = s.rate * s.rate;
  s.strain_rate = Step::StrainRate::predicted;
  out.drift.resize(start.x.size());
  out.predicted.resize(start.x.size());
  for (std::size_t i = 0; i < start.x.size(); ++i) {
    const Vec3 repeated = kRepeat * kGamma * whole * (start.v[i] - 0.5 * moved[i]);
    out.drift[i] = -s.rate * repeated;
    out.predicted[i] = start.x[i] + repeated + (start.v[i] + kRepeat * change[i]) / s.rate;
  }
  s.drift = &out.drift;
}

}  // namespace retiarius
