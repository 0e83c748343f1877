// Folding: grips are drawn together under gravity, the threads between them hang as catenaries.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/forces/bending.hpp"
#include "retiarius/measure/bundle.hpp"
#include "retiarius/mission/catenary.hpp"
#include "retiarius/mission/grips.hpp"
#include "retiarius/mission/phase_action.hpp"

namespace retiarius {

namespace {

// Sag over length of the first shape: enough for the threads to hang, little against the mesh.
constexpr double kFirstSag = 0.02;

// All grips keep their height and draw together towards the net's centre in one proportion, so
// that every thread between two grips has the same span over length, hence the same catenary. The
// sag grows smoothly from the first shape's to the last; the spans follow from catenary theory.
// (Spans that shrink at a constant speed would let the threads drop at an infinite one first.)
class Fold final : public PhaseAction {
 public:
  Fold(const PhaseSpec& phase, const Network& network, const MissionFrame& frame)
      : phase_(phase), frame_(frame), grips_(choose_grips(phase, network)) {
    if (phase.environment.gravity.isZero(0.0))
      throw InputError(phase.place, fmt::format("phase \"{}\": folding lets threads hang, which "
                                                "needs environment.gravity; give it here as "
                                                "[phase.environment]",
                                                phase.name));
    last_sag_ = catenary_from_span(phase.ratio).sag_ratio;
  }

  void begin(Simulation& sim) override {
    start_ = sim.state().time;
    const Network& network = sim.network();
    center_ = sim.state().x[network.center];
    for (Index g : grips_) places_.push_back(sim.state().x[g]);
    const bool first = frame_.fresh && sim.state().step == 0;
    first_sag_ = first ? std::min(kFirstSag, last_sag_) : 0.0;
    if (first_sag_ > 0.0) hang(sim);
  }

  std::optional<double> next_event(double now) const override {
    const double end = start_ + phase_.duration;
    return end > now ? std::optional(end) : std::nullopt;
  }

  bool moves() const override { return true; }

  void prescribe(const Simulation&, double time, std::vector<Prescribed>& out) const override {
    const double s = std::clamp((time - start_) / phase_.duration, 0.0, 1.0);
    const double sag = first_sag_ + (last_sag_ - first_sag_) * s * s * (3.0 - 2.0 * s);
    const Catenary c = catenary_from_sag(sag);
    const double sag_rate = (last_sag_ - first_sag_) * 6.0 * s * (1.0 - s) / phase_.duration;
    const double rate = span_slope(c) * sag_rate;
    for (std::size_t k = 0; k < grips_.size(); ++k) {
      const Vec3 arm = places_[k] - center_;
      out.push_back({grips_[k], center_ + c.span_ratio * arm, rate * arm});
    }
  }

  void transfer(Archive& archive) override { archive(places_, center_, start_, first_sag_); }

  Measures measures(const Simulation& sim) const override {
    const Bundle bundle = measure_bundle(sim.network(), sim.state().x, frame_.axis);
    const std::vector<double> curvature = node_curvatures(sim.network(), sim.state().x);
    const double largest = *std::max_element(curvature.begin(), curvature.end());
    return {{"grips", "", static_cast<std::int64_t>(grips_.size())},
            {"bundle_diameter", "m", bundle.diameter},
            {"bundle_height", "m", bundle.height},
            {"packing_ratio", "", bundle.packing_ratio},
            {"largest_curvature", "1/m", largest}};
  }

 private:
  // d(span / L) / d(sag / L), from span / L = u / sinh u and sag / L = tanh(u / 2) / 2.
  static double span_slope(const Catenary& c) {
    const double u = c.parameter;
    if (u < 1e-6) return -16.0 / 3.0 * c.sag_ratio;
    const double span = (1.0 - u / std::tanh(u)) / std::sinh(u);
    const double sag = 0.25 / std::pow(std::cosh(0.5 * u), 2);
    return span / sag;
  }

  // The mission's first shape: threads between neighbouring grips as catenaries of a small sag,
  // the rest of the net at rest among them.
  void hang(Simulation& sim) const {
    std::vector<Prescribed> held;
    prescribe(sim, start_, held);
    for (Prescribed& p : held) p.velocity.setZero();
    const Vec3 down = sim.environment().gravity.normalized();
    const Catenary c = catenary_from_sag(first_sag_);
    std::vector<bool> gripped(sim.state().x.size(), false);
    for (Index g : grips_) gripped[g] = true;
    std::vector<Vec3> x = sim.state().x;
    for (Vec3& p : x) p = center_ + c.span_ratio * (p - center_);
    for (const Thread& t : sim.network().threads)
      hang_thread(sim.network(), t, gripped, down, c, x);
    sim.place(x);
    sim.solve_static(held);
  }

  static void hang_thread(const Network& network, const Thread& thread,
                          const std::vector<bool>& gripped, const Vec3& down, const Catenary& c,
                          std::vector<Vec3>& x) {
    std::size_t last = thread.nodes.size();
    double length = 0.0;
    std::vector<double> arc;
    for (std::size_t k = 0; k < thread.nodes.size(); ++k) {
      if (k > 0) length += network.segments[thread.segments[k - 1]].rest_length;
      arc.push_back(length);
      if (!gripped[thread.nodes[k]]) continue;
      if (last < k) {
        const double whole = arc[k] - arc[last];
        const Vec3 a = x[thread.nodes[last]];
        const Vec3 b = x[thread.nodes[k]];
        for (std::size_t m = last + 1; m < k; ++m) {
          const CatenaryPoint p = catenary_point(c, (arc[m] - arc[last]) / whole);
          x[thread.nodes[m]] = a + p.along / c.span_ratio * (b - a) + p.down * whole * down;
        }
      }
      last = k;
    }
  }

  PhaseSpec phase_;
  MissionFrame frame_;
  std::vector<Index> grips_;
  std::vector<Vec3> places_;  // of the grips at the start
  Vec3 center_ = Vec3::Zero();
  double start_ = 0.0;
  double first_sag_ = 0.0, last_sag_ = 0.0;  // over length
};

}  // namespace

std::unique_ptr<PhaseAction> make_fold(const PhaseSpec& phase, const Network& network,
                                       const MissionFrame& frame) {
  return std::make_unique<Fold>(phase, network, frame);
}

}  // namespace retiarius
