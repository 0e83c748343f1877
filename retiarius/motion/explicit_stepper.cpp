#include "retiarius/motion/explicit_stepper.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/solve/flush_denormals.hpp"

namespace retiarius {

namespace {

// The cubic of a way at share s of the step of length h.
Vec3 place_on(const ExplicitStepper::Way& w, double s, double h) {
  const Vec3 whole = w.to - w.from;
  const Vec3 a = h * w.start_velocity - whole, b = whole - h * w.end_velocity;
  return w.from + s * whole + s * (1.0 - s) * ((1.0 - s) * a + s * b);
}

Step as_seen(const State& at, double kick) {
  Step step;
  step.start = &at;
  step.h = kick;
  step.carry = -1.0;
  step.strain_rate = Step::StrainRate::start;
  return step;
}

}  // namespace

ExplicitStepper::ExplicitStepper(const Network& network)
    : network_(&network),
      total_mass_(std::accumulate(network.mass.begin(), network.mass.end(), 0.0)) {}

void ExplicitStepper::prepare(const Job& job, const State& state) {
  const bool same = std::equal(alone_.begin(), alone_.end(), job.ways.begin(), job.ways.end(),
                               [](Index node, const Way& way) { return node == way.node; });
  if (!layout_ || !same) {
    alone_.clear();
    for (const Way& way : job.ways) alone_.push_back(way.node);
    std::vector<char> flags(network_->mass.size(), 0);
    for (const Index node : alone_) flags[node] = 1;
    layout_ = std::make_unique<SweepLayout>(*network_, flags);
    held_ = std::move(flags);
    const auto size = static_cast<std::size_t>(layout_->size());
    x_.resize(size);
    v_.resize(size);
  }
  const auto size = static_cast<std::size_t>(layout_->size());
  std::fill_n(x_.data(), size, 0.0);
  std::fill_n(v_.data(), size, 0.0);
  momentum_ = first_moment_ = Vec3::Zero();
  for (std::size_t i = 0; i < state.x.size(); ++i) {
    layout_->write(x_.data(), static_cast<Index>(i), state.x[i]);
    layout_->write(v_.data(), static_cast<Index>(i), state.v[i]);
    momentum_ += network_->mass[i] * state.v[i];
    first_moment_ += network_->mass[i] * state.x[i];
  }
  driven_.clear();
  for (const Way& way : job.ways) {
    Driven d;
    d.way = way;
    d.x = state.x[way.node];
    d.v = state.v[way.node];
    driven_.push_back(d);
  }
  const double h = job.h / job.substeps;
  layout_->begin(state.x, state.v, h, job.stretches);
  sweep_ = {};
  sweep_.x = x_.data();
  sweep_.v = v_.data();
  layout_->bind(sweep_);
  Eigen::Map<Vec3>(sweep_.g) = job.gravity;
  if (!job.laws.empty()) {
    force_.assign(size, 0.0);
    sweep_.force = force_.data();
    at_.x = state.x;
    at_.v = state.v;
    gradient_.resize(state.x.size());
    moved_.resize(state.x.size());
  }
  if (!job.laws.empty() || job.damping > 0.0) old_v_.assign(v_.data(), v_.data() + size);
}

// Forces of the laws that the sweep does not know, at x(n) and a velocity of second order there.
void ExplicitStepper::add_laws(const Job& job, int n, double kick) {
  const double ahead = n == 0 ? 0.0 : n == 1 ? 1.0 : 0.5;  // of the last kick
  for (std::size_t i = 0; i < at_.x.size(); ++i) {
    const Index node = static_cast<Index>(i);
    const Vec3 v = layout_->read(v_.data(), node);
    at_.x[i] = layout_->read(x_.data(), node);
    at_.v[i] = v + ahead * (v - layout_->read(old_v_.data(), node));
  }
  std::fill(gradient_.begin(), gradient_.end(), Vec3::Zero());
  const Step step = as_seen(at_, kick);
  Assembly out{&gradient_, nullptr, false};
  for (Law* law : job.laws) {
    law->prepare(step);
    law->assemble(step, at_.x, out);
  }
  for (std::size_t i = 0; i < at_.x.size(); ++i)
    layout_->write(force_.data(), static_cast<Index>(i), -gradient_[i]);
}

// What the laws exchanged over the kick's interval, in which the nodes move by their mean velocity.
void ExplicitStepper::book_laws(const Job& job, double kick, Account& account) {
  for (std::size_t i = 0; i < moved_.size(); ++i) {
    const Index node = static_cast<Index>(i);
    moved_[i] = at_.x[i] +
                0.5 * kick * (layout_->read(old_v_.data(), node) + layout_->read(v_.data(), node));
  }
  Exchange exchange;
  for (const Law* law : job.laws) law->account(as_seen(at_, kick), at_.x, moved_, exchange);
  account.material_loss += exchange.material_loss;
  account.environment_loss += exchange.environment_loss;
  account.outside_impulse += exchange.outside_impulse;
  account.outside_angular_impulse += exchange.outside_angular_impulse;
}

// Puts prescribed nodes on their ways, with the impulse and work that this takes.
void ExplicitStepper::drive(const Job& job, int n, double kick, Account& account) {
  const bool last = n == job.substeps;
  const double h = job.h / job.substeps;
  for (Driven& d : driven_) {
    const Index i = d.way.node;
    const double m = network_->mass[i];
    const Vec3 place = n + 1 >= job.substeps
                           ? d.way.to
                           : place_on(d.way, static_cast<double>(n + 1) / job.substeps, job.h);
    const Vec3 v = last ? d.way.final_velocity : Vec3((place - d.x) / h);
    Vec3 force = layout_->force(i) + m * job.gravity - 0.5 * job.damping * m * (d.v + v);
    if (sweep_.force) force += layout_->read(sweep_.force, i);
    const Vec3 support = m * (v - d.v) - kick * force;
    d.impulse += support;
    momentum_ += support;
    account.prescribed_work += 0.5 * support.dot(d.v + v);
    account.outside_impulse += support;
    account.outside_angular_impulse += d.x.cross(support);
    layout_->write(v_.data(), i, v);
    layout_->write(x_.data(), i, place);
    d.v = v;
    d.x = place;
  }
}

void ExplicitStepper::book_damping(const Job& job, double kick, double drift, Account& account) {
  for (std::size_t i = 0; i < network_->mass.size(); ++i) {
    const Index node = static_cast<Index>(i);
    const Vec3 v = layout_->read(v_.data(), node);
    const Vec3 mean = 0.5 * (layout_->read(old_v_.data(), node) + v);
    const Vec3 impulse = -kick * job.damping * network_->mass[i] * mean;
    account.environment_loss -= impulse.dot(mean);
    account.outside_impulse += impulse;
    account.outside_angular_impulse += (layout_->read(x_.data(), node) - drift * v).cross(impulse);
    momentum_ += impulse;
  }
}

void ExplicitStepper::check_finite(const State& state) const {
  for (std::size_t i = 0; i < state.x.size(); ++i) {
    if (state.x[i].allFinite() && state.v[i].allFinite()) continue;
    throw RunError(
        fmt::format("the explicit integrator has lost node {} in the step to {:.9g} s: its place "
                    "or velocity is no longer finite. Take a smaller integrator.substep or "
                    "integrator.method = \"implicit-euler\"",
                    i, state.time));
  }
}

void ExplicitStepper::run(const Job& job, const std::vector<BodyState>& free, State& state) {
  prepare(job, state);
  const double h = job.h / job.substeps;
  if (job.contact)
    job.contact->begin({layout_.get(), x_.data(), v_.data(), &network_->mass, &held_}, state, h);
  // Denormal numbers are slow, and below what counts.
  const FlushDenormals flush;
  const kernels::SweepTable& table = kernels::sweeps();
  Account& account = state.account;
  for (int n = 0; n <= job.substeps; ++n) {
    const bool last = n == job.substeps;
    const double kick = n == 0 || last ? 0.5 * h : h;
    sweep_.keep = (1.0 - 0.5 * kick * job.damping) / (1.0 + 0.5 * kick * job.damping);
    sweep_.gain = kick / (1.0 + 0.5 * kick * job.damping);
    sweep_.drift = last ? 0.0 : h;
    const bool needs_old = !job.laws.empty() || job.damping > 0.0;
    if (!job.laws.empty()) add_laws(job, n, kick);
    if (needs_old) std::copy_n(v_.data(), old_v_.size(), old_v_.data());
    double fastest = 0.0;
    const double loss =
        table.sweep(layout_->groups().data(), static_cast<long>(layout_->groups().size()), sweep_,
                    last, &fastest);
    sweep_.last = 1 - sweep_.last;
    // The first evaluation follows none: its loss is of the step before.
    if (n > 0) account.material_loss += loss;
    table.move_shared(layout_->runs().data(), static_cast<long>(layout_->runs().size()), sweep_,
                      &fastest);
    const Vec3 weight = kick * job.gravity;
    account.outside_impulse += total_mass_ * weight;
    account.outside_angular_impulse += first_moment_.cross(weight);
    momentum_ += total_mass_ * weight;
    drive(job, n, kick, account);
    if (job.damping > 0.0) book_damping(job, kick, sweep_.drift, account);
    if (!job.laws.empty()) book_laws(job, kick, account);
    if (job.contact && !last) {
      const ExplicitContact::Given given =
          job.contact->step(job.body_gravity, kick, sweep_.drift * fastest, account);
      momentum_ += given.impulse;
      first_moment_ += given.shift;
    }
    if (job.contact && last) job.contact->finish(job.body_gravity, kick, account);
    first_moment_ += sweep_.drift * momentum_;
  }
  for (std::size_t i = 0; i < state.x.size(); ++i) {
    state.x[i] = layout_->read(x_.data(), static_cast<Index>(i));
    state.v[i] = layout_->read(v_.data(), static_cast<Index>(i));
  }
  std::fill(state.support.begin(), state.support.end(), Vec3::Zero());
  for (const Driven& d : driven_) state.support[d.way.node] = d.impulse / job.h;
  state.bodies = free;
  state.touches.clear();
  if (job.contact) job.contact->end(job.h, state.bodies, state.touches);
  check_finite(state);
}

}  // namespace retiarius
