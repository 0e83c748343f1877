#include "retiarius/solve/newton.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace retiarius {

namespace {

constexpr double kArmijo = 1e-4;
constexpr std::size_t kMemory = 3;   // iterates that a whole step may be compared with
constexpr int kMostTrials = 40;      // of a shorter step
constexpr int kMostRises = 2;        // to iterates higher than the one before
constexpr double kLongest = 1e3;     // step, over Newton's
constexpr double kSteep = 0.3;       // slope at a step's end, over that at its start
constexpr double kGrowth = 4.0;      // of a step that is made longer, at a time
constexpr double kKinkWidth = 0.02;  // of the place of a kink that a shortened step ends at
constexpr int kProjected = 3;        // matrices in a row with contact projected, once one had to be

// Of watchdog steps, see venture(). With two instead of three of them, tried already after one
// short step or only below 0.3 of a whole one, captures need up to 6 per cent more iterations.
constexpr int kVentures = 3;
constexpr double kShort = 0.5;      // of what is free of a direction
constexpr double kBoldRise = 20.0;  // of the potential, over the slope
constexpr double kFarther = 1.5;    // than the short step goes; else a bold one is not worth it

// Ratios of the lengths of consecutive steps. Between 0.05 and 0.3 for the first and 0.2 and 0.5
// for the second the cost of falling nets changes by a few per cent.
constexpr double kFastNewton = 0.1;
constexpr double kFastChord = 0.3;

class Iteration {
 public:
  Iteration(NewtonProblem& problem, const NewtonSettings& settings)
      : problem_(problem), settings_(settings) {}

  NewtonResult run();

 private:
  bool find_direction();
  bool find_descent();
  void choose_next(double size);
  double line_search();
  double shorten(double slope, double most, double high_slope);
  double lengthen(double slope);
  double venture(double slope, double at, double fraction);
  void restart();

  NewtonProblem& problem_;
  const NewtonSettings& settings_;
  NewtonResult result_;
  double value_ = 0.0;          // the potential
  double shortened_ = 0.0;      // the potential where a step was last shortened to
  double size_ = 0.0;           // of the direction
  double fraction_ = 1.0;       // taken of the direction before
  double recent_[kMemory];      // potentials of the last iterates
  std::size_t remembered_ = 0;  // of those
  int rises_ = 0;               // accepted so far
  double size_before_ = 0.0;    // of the last whole step; 0: none to compare with
  double ratio_before_ = 0.0;   // residual ratio after the last step
  Projected next_projection_ = Projected::nothing;  // of the next matrix
  int projections_left_ = 0;                        // ... and those after it
  bool chord_ = false;          // the present direction comes from an old factorisation
  bool next_is_chord_ = false;  // ... and so will the next
};

// A direction from the old factorisation where that was chosen and descends, else from a new one.
bool Iteration::find_direction() {
  chord_ = next_is_chord_;
  if (chord_) {
    problem_.reuse_direction();
    if (problem_.slope() <= 0.0) return true;
    chord_ = false;
    value_ = problem_.assemble(next_projection_);
  }
  return find_descent();
}

// With the full Hessian first, with the projected one if that has a pivot that is not positive.
// Matrices after one with contact projected would mostly need it too: they are tried with it first.
bool Iteration::find_descent() {
  ++result_.factorisations;
  const bool projected = next_projection_ == Projected::contact;
  result_.projections += projected ? 1 : 0;
  if (problem_.find_direction() && problem_.slope() <= 0.0) {
    if (!projected || --projections_left_ == 0) next_projection_ = Projected::nothing;
    return true;
  }
  if (!projected) ++result_.projections;
  if (!projected && problem_.has_contact()) {
    problem_.assemble(Projected::contact);
    next_projection_ = Projected::contact;
    projections_left_ = kProjected;
    if (problem_.find_direction() && problem_.slope() <= 0.0) return true;
  }
  problem_.assemble(Projected::everything);
  return problem_.find_direction() && problem_.slope() <= 0.0;
}

// Whether the next direction can do with this factorisation; known before the line search, which
// then leaves the Hessian out.
void Iteration::choose_next(double size) {
  const double rate = size_before_ > 0.0 ? size / size_before_ : 1.0;
  const bool last = size <= settings_.step_tolerance;
  const bool is_short = !chord_ && size <= settings_.chord_step;
  next_is_chord_ =
      settings_.reuse && (last || is_short || rate <= (chord_ ? kFastChord : kFastNewton));
  size_before_ = size;
}

// Takes the whole step, or what is free of it, where the potential falls enough (Armijo) against
// the largest of the last few iterates (Grippo, Lampariello and Lucidi 1986: where tension-only
// threads become taut, the way down leads over small rises; more than a few of these are circles).
// Close to the minimum the fall drowns in round-off; there a step counts as good if it leaves a
// smaller slope (Hager and Zhang 2005). Else a shorter one is looked for, or some bold ones where
// steps keep being short, and a longer one where a whole step ends on as steep a slope as it began.
// Returns the accepted fraction of the last direction with the problem assembled there, or 0.
double Iteration::line_search() {
  const double slope = problem_.slope();
  const double noise = 1e-12 * std::abs(value_) + 1e-300;
  if (remembered_ == kMemory)
    std::copy(recent_ + 1, recent_ + kMemory, recent_);
  else
    ++remembered_;
  recent_[remembered_ - 1] = value_;
  const double reference = *std::max_element(recent_, recent_ + remembered_);
  const double most = problem_.free_fraction(1.0);
  if (most < 1.0) {
    next_is_chord_ = false;
    size_before_ = 0.0;
  }
  problem_.move(most);
  const double trial = next_is_chord_ ? problem_.evaluate() : problem_.assemble(next_projection_);
  const bool descends = trial <= value_ + kArmijo * most * slope;
  const bool falls =
      descends || (rises_ < kMostRises && trial <= reference + kArmijo * most * slope);
  const double blur = noise + settings_.round_off_step * problem_.largest_force();
  const bool level =
      std::abs(trial - value_) <= blur && std::abs(problem_.slope()) <= 0.9 * std::abs(slope);
  const bool still = std::abs(slope) <= noise;
  if (std::isfinite(trial) && (falls || level || still)) {
    rises_ += descends ? 0 : 1;
    value_ = trial;
    return most == 1.0 && !chord_ && falls ? lengthen(slope) : most;
  }
  const double fraction = shorten(slope, most, std::isfinite(trial) ? problem_.slope() : -1.0);
  const bool creeps = fraction < kShort * most && fraction_ < 1.0 && fraction > 0.0;
  if (creeps && !chord_ && std::isfinite(trial)) {
    // The potential of threads that turn rises with the fourth power of the way.
    const double bold = kBoldRise * std::abs(slope), rise = trial - value_;
    const double at = rise > bold ? most * std::pow(bold / rise, 0.25) : most;
    if (at > kFarther * fraction) return venture(slope, at, fraction);
  }
  if (fraction > 0.0) restart();
  return fraction;
}

// Where the way down is narrow and bent, as that of taut threads that turn (their length is kept to
// first order by a direction, and beyond by the next one), steps straight ahead are all short. So
// some whole steps are taken wherever they lead, the first as far as `at`; what they find counts
// where it lies lower than the shortened step (the watchdog of Chamberlain, Powell, Lemarechal and
// Pedersen 1982), and else that is taken after all.
double Iteration::venture(double slope, double at, double fraction) {
  const double straight = size_;
  problem_.move(at);
  problem_.keep_direction();
  const double wanted = std::min(shortened_, value_ + kArmijo * at * slope);
  for (int k = 0; k < kVentures && result_.iterations < settings_.max_iterations; ++k) {
    if (!std::isfinite(problem_.assemble(next_projection_))) break;
    ++result_.iterations;
    ++result_.factorisations;
    if (!problem_.find_direction() || problem_.slope() > 0.0) break;
    const double free = problem_.free_fraction(1.0);
    problem_.move(free);
    if (!(problem_.evaluate() < wanted)) continue;
    size_ = problem_.direction_size();
    restart();
    return free;
  }
  problem_.restore_direction();
  size_ = straight;
  const double free = problem_.free_fraction(fraction);
  problem_.move(free);
  restart();
  return free;
}

// Looks for the place along the direction where the slope vanishes, between `low` where the
// potential still falls and `high` where it rises or has not fallen enough, by the secant of the
// slopes; in the middle where the same end moved twice, since a thread that becomes taut at the far
// end keeps the secant at the near one. Ends where the potential has fallen enough and the slope is
// half of that at the start, or where a kink between the two ends is found closely enough.
double Iteration::shorten(double slope, double most, double high_slope) {
  double low = 0.0, low_slope = slope, high = most, best = 0.0;
  int moved = 0;  // how often the low end moved in a row; negative: the high one
  for (int trials = 0; trials < kMostTrials; ++trials) {
    const double width = high - low;
    double at = low + 0.5 * width;
    if (high_slope > 0.0 && std::abs(moved) < 2)
      at = low - low_slope * width / (high_slope - low_slope);
    at = std::clamp(at, low + 0.05 * width, high - 0.05 * width);
    problem_.move(at);
    const double trial = problem_.evaluate();
    const double here = std::isfinite(trial) ? problem_.slope() : -1.0;
    const bool falls = trial <= value_ + kArmijo * at * slope;
    if (falls) {
      best = at;
      shortened_ = trial;
    }
    if (falls && std::abs(here) <= 0.5 * std::abs(slope)) break;
    if (falls && here < 0.0) {
      low = at;
      low_slope = here;
      moved = std::max(moved, 0) + 1;
    } else {
      high = at;
      high_slope = here;
      moved = std::min(moved, 0) - 1;
    }
    if (best > 0.0 && high - low <= kKinkWidth * high) break;
  }
  problem_.move(best);
  return best;
}

// Goes on beyond the whole step while the potential falls there nearly as steeply as at its start
// (the matrix was projected, or the potential is nearly straight): by the secant of the slopes, at
// most fourfold at a time.
double Iteration::lengthen(double slope) {
  double at = 1.0, here = problem_.slope();
  if (here >= kSteep * slope) return at;
  bool left = false;  // the place of the last assembly
  while (at < kLongest && here < kSteep * slope) {
    const double secant = here < 0.75 * slope ? kGrowth : slope / (slope - here);
    const double next = problem_.free_fraction(at * secant);
    if (next <= 1.2 * at) break;
    left = true;
    problem_.move(next);
    const double trial = problem_.evaluate();
    if (!std::isfinite(trial) || trial > value_ + kArmijo * (next - at) * here) break;
    at = next;
    value_ = trial;
    here = problem_.slope();
  }
  problem_.move(at);
  if (left) restart();
  return at;
}

// Assembles at the present iterate; what was learned of the steps' lengths is forgotten.
void Iteration::restart() {
  value_ = problem_.assemble(next_projection_);
  next_is_chord_ = false;
  size_before_ = 0.0;
}

NewtonResult Iteration::run() {
  value_ = problem_.assemble(Projected::nothing);
  while (result_.iterations < settings_.max_iterations) {
    if (!std::isfinite(value_)) {
      result_.failure = "the potential is not finite";
      return result_;
    }
    ++result_.iterations;
    if (!find_direction()) {
      result_.failure = "the projected matrix is not positive definite";
      return result_;
    }
    size_ = problem_.direction_size();
    choose_next(size_);
    const double fraction = line_search();
    if (fraction == 0.0) {
      if (chord_) {  // the old factorisation is to blame first
        problem_.move(0.0);
        restart();
        continue;
      }
      result_.failure =
          fmt::format("the line search found no descent at iteration {}", result_.iterations);
      return result_;
    }
    fraction_ = fraction;
    const double moved = size_ * fraction;
    const double ratio = problem_.residual_ratio();
    if (chord_ && next_is_chord_ && ratio > 0.5 * ratio_before_ && ratio > 1.0) restart();
    ratio_before_ = ratio;
    const bool full = (moved <= settings_.step_tolerance && ratio <= 1.0) ||
                      (moved <= settings_.round_off_step && ratio <= settings_.round_off_ratio);
    const bool loose = fraction == 1.0 && size_ <= settings_.loose_step_tolerance &&
                       ratio <= settings_.loose_residual_ratio;
    if ((full || loose) && problem_.revise(full)) {
      remembered_ = 0;
      next_projection_ = Projected::nothing;
      restart();
      continue;
    }
    if (full) {
      result_.converged = true;
      return result_;
    }
  }
  result_.failure = fmt::format("no convergence within {} iterations", settings_.max_iterations);
  return result_;
}

}  // namespace

NewtonResult update_once(NewtonProblem& problem) {
  NewtonResult result;
  result.iterations = result.factorisations = 1;
  if (!std::isfinite(problem.assemble(Projected::nothing))) {
    result.failure = "the potential is not finite";
    return result;
  }
  result.converged = problem.find_direction();
  if (!result.converged) {
    ++result.factorisations;
    ++result.projections;
    problem.assemble(Projected::everything);
    result.converged = problem.find_direction();
  }
  if (!result.converged) {
    result.failure = "the projected matrix is not positive definite";
    return result;
  }
  problem.move(1.0);
  problem.linearise();
  return result;
}

NewtonResult minimise(NewtonProblem& problem, const NewtonSettings& settings) {
  return Iteration(problem, settings).run();
}

}  // namespace retiarius
