// Contact by barriers: threads, bodies and threads among themselves never interpenetrate.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "retiarius/base/archive.hpp"
#include "retiarius/base/block_matrix.hpp"
#include "retiarius/bodies/body.hpp"
#include "retiarius/contact/broad_phase.hpp"
#include "retiarius/contact/collision_scene.hpp"
#include "retiarius/contact/distance.hpp"
#include "retiarius/contact/spec.hpp"
#include "retiarius/net/network.hpp"
#include "retiarius/state/step.hpp"

namespace retiarius {

using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;
using Mat36 = Eigen::Matrix<double, 3, 6>;

// Where everything is at a step's end. `turn` is the rotation vector by which each body's attitude
// differs from that of its free motion, in which its derivatives are wanted.
struct ContactPlaces {
  const std::vector<Vec3>* nodes = nullptr;
  const std::vector<BodyState>* bodies = nullptr;
  const std::vector<Vec3>* turns = nullptr;
};

// What contact writes into. Of bodies the unknowns are translation and rotation vector.
struct ContactAssembly {
  struct NodeBody {
    Index node, body;
    Mat36 block;
  };
  struct BodyBody {
    Index first, second;  // first <= second; of two different bodies the transpose is implied
    Mat6 block;
  };
  std::vector<Vec3>* gradient = nullptr;       // N, of each node
  std::vector<Vec6>* body_gradient = nullptr;  // N and N m
  BlockMatrix* hessian = nullptr;              // of the net; null: no second derivatives
  std::vector<NodeBody>* node_body = nullptr;
  std::vector<BodyBody>* body_body = nullptr;
  double scale = 1.0;  // of the second derivatives
  bool definite = false;
};

// One pair in contact, as the accounts and measures need it.
struct PairContact {
  ContactPair pair;
  std::array<PointPlace, 4> places;
  std::array<Vec3, 4> place;        // of the points, m
  std::array<double, 4> weight{};   // of the points in the contact's place
  Vec3 normal = Vec3::UnitZ();      // from the second primitive to the first
  Vec3 point = Vec3::Zero();        // m, on the second primitive
  double gap = 0.0;                 // between the surfaces, m
  double force = 0.0;               // normal, N, at least 0
  double energy = 0.0;              // of the barrier, J
  std::array<Vec3, 4> point_force;  // on each point: normal force and friction, N
  Vec3 friction = Vec3::Zero();     // on the first primitive, N
  Vec3 slip = Vec3::Zero();         // tangential, of the first against the second, m
};

// Throws Error where bytes are no contact.
void transfer(Archive& archive, PairContact& contact);

// Incremental potential contact (Li et al. 2020) with the threads' and bodies' own thickness (Li
// et al. 2021): every pair of primitives whose surfaces are nearer than the range r has the energy
//   E = k m(edges) b(g),   g = distance - thickness,
// with the barrier b of barrier_function.hpp, infinite where surfaces meet, and m the weight of
// nearly parallel edges. The stiffness is chosen by scale, k = m_red / h^2 + EA / (1e5 r), with
// the reduced mass of the two primitives: what stops a node within a step, and what carries a
// thread strained by 1e-5, both within the range. More load takes surfaces nearer to each other.
//
// Friction is Coulomb's made smooth, with normal forces and directions of the last round: those of
// the step's start first, then those foretold while it is solved, and those of the solution, until
// they change by less than `friction_tolerance` or after `friction_rounds`.
class BarrierContact {
 public:
  // step: the nominal one, s. All but `spec` must outlive this.
  BarrierContact(const Network& network, const std::vector<Body>& bodies, const ContactSpec& spec,
                 double step);

  // Starts a step from its start state. The time spent on looking for what may touch is added to
  // `search_time`, s, until the next call. Throws RunError, naming the pair, where anything
  // interpenetrates there.
  void begin(const Step& step, double& search_time);

  // Finds what may come near on the way from `from` to `to`, and returns the share of it, in (0,
  // 1], on which nothing comes nearer than a tenth of its present gap. All evaluations until the
  // next call must lie on this way.
  double look_ahead(const ContactPlaces& from, const ContactPlaces& to);

  // The pairs that come too near on the last way looked along.
  const std::vector<ContactPair>& blocked() const { return blocked_; }

  // The potential at a place, J (infinite where anything interpenetrates), with its derivatives
  // where `out` is given.
  double evaluate(const ContactPlaces& at, ContactAssembly* out);

  // By how much forces may be wrong for rounding of the places, N, at the last evaluation.
  double force_round_off() const { return force_round_off_; }

  // The pairs of nodes (smaller first, ascending, unique) that threads couple at a place: those
  // within the range, or in reach of it where these are wanted too, and those that friction joins
  // in this round.
  enum class Coupled { in_range, in_reach };
  std::vector<std::pair<Index, Index>> couplings(const ContactPlaces& at, Coupled which);

  // Notes a direction from the place last evaluated, with second derivatives, to another. The next
  // Hessian takes each pair's barrier as its force at the end of the direction, foretold by the
  // last Hessian, demands it, and tells by the slips at the start those that slip on from those
  // that turned back.
  void note_direction(const ContactPlaces& from, const ContactPlaces& to);

  // Whether friction must be solved again: with the normal forces of this place where it solves the
  // step, else with those foretold.
  bool revise(const ContactPlaces& at, bool solved);

  // Whether the straight motion from the step's start to its end keeps every pair at least
  // kMotionShare of its thickness apart; `pair` gets the name of one that it does not.
  bool motion_is_free(const ContactPlaces& start, const ContactPlaces& end, std::string& pair);
  static constexpr double kMotionShare = 0.5;

  // The contacts at a place, friction by the last round's normal forces.
  void contacts(const ContactPlaces& at, std::vector<PairContact>& result);

  // Whether bodies touch nothing, from the next step on; threads touch each other all the same.
  void leave_bodies_out(bool out) { broad_->leave_bodies_out(out); }
  bool touches_itself() const { return spec_.self; }
  double range() const { return range_; }
  const CollisionScene& scene() const { return scene_; }
  const Network& network() const { return *network_; }

 private:
  // Candidates, and pairs in contact, in one piece of parallel work.
  static constexpr std::size_t kGrain = 64, kTermGrain = 16;

  // A contact whose friction acts in this round.
  struct Sliding {
    ContactPair pair;
    std::array<PointPlace, 4> places;
    int count = 0;
    std::array<double, 4> weight{};
    Vec3 normal;
    double force = 0.0;          // normal, N
    std::array<Vec3, 4> start;   // of the points at the step's start, m
    Vec3 before = Vec3::Zero();  // the slip where the last direction began, m
  };
  // Of a body at the place that is evaluated.
  struct BodyPlace {
    Vec3 position;
    Mat3 attitude;
    Mat3 turning;  // d(turn of the world) / d(rotation vector)
    bool moves = false;
  };
  // What a pair adds at the place that is evaluated, in its points' coordinates.
  struct Term {
    std::array<PointPlace, 4> places;
    int count = 0;
    double energy = 0.0, round_off = 0.0;  // J; N
    Vec12 gradient = Vec12::Zero();
    Mat12 hessian = Mat12::Zero();
    // Of a barrier: the distance's gradient, and -b' in m and the b'' that the Hessian was made of.
    ContactPair pair;
    Vec12 widening = Vec12::Zero();
    double push = 0.0, bend = 0.0;
  };
  // The force -b' of a pair's barrier at the end of the last direction, m.
  struct Foretold {
    ContactPair pair;
    double push;
  };
  // A pair at the place that is evaluated.
  struct Near {
    PairPositions p;
    Distance distance;
    double gap = 0.0, stiffness = 0.0;
    std::array<PointPlace, 4> places;
    EdgeWeight weight;
    bool edges = false;
    double force = 0.0;  // normal, N
    Vec12 gradient = Vec12::Zero();
    double energy = 0.0, slope = 0.0, curvature = 0.0;  // of the barrier, stiffness included
  };

  double stiffness(const ContactPair& pair, const std::array<PointPlace, 4>& places) const;
  double mass_of(Index owner, const PointPlace* places, int count) const;
  void place_bodies(const ContactPlaces& at);
  Vec3 world(const PointPlace& place, const ContactPlaces& at) const;
  bool is_near(const ContactPair& pair, const ContactPlaces& at, bool derivatives,
               Near& near) const;
  bool is_near_searched(const ContactPlaces& at) const;
  const std::vector<ContactPair>& search(const ContactPlaces& from, const ContactPlaces& to);
  void keep_gaps();
  bool is_last_evaluated(const ContactPlaces& at) const;
  void bound_ways();
  double way(const ContactPair& pair) const;
  double gap(const ContactPair& pair, const ContactPlaces& at) const;
  void mark_near(const ContactPlaces& at);
  void barrier_term(const ContactPair& pair, const ContactPlaces& at, const ContactAssembly* out,
                    Term& term) const;
  void friction_term(const Sliding& s, const ContactPlaces& at, const ContactAssembly* out,
                     Term& term) const;
  const Foretold* foretold(const ContactPair& pair) const;
  double coefficient(const ContactPair& pair) const;
  Vec3 slip(const Sliding& s, const ContactPlaces& at) const;
  void scatter(const Term& term, const ContactPlaces& at, ContactAssembly& out) const;
  void scatter_net(const std::array<PointPlace, 4>& places, int count, const Mat12& hessian,
                   ContactAssembly& out) const;
  void scatter_body(const std::array<PointPlace, 4>& places, const std::array<Index, 4>& body,
                    int begin, int end, const std::array<Mat36, 4>& moves, const Mat12& hessian,
                    ContactAssembly& out) const;
  void slidings(const ContactPlaces& at, bool foretold_forces, std::vector<Sliding>& result);
  void add_friction_to(std::vector<PairContact>& contacts, const Sliding& s,
                       const ContactPlaces& at) const;
  std::string name(const ContactPair& pair) const;

  const Network* network_;
  const std::vector<Body>* bodies_;
  ContactSpec spec_;
  double step_size_, range_, slack_;
  CollisionScene scene_;
  std::optional<ThreadNeighbours> neighbours_;
  std::optional<BroadPhase> broad_;
  double axial_stiffness_ = 0.0;  // of the stiffest thread, N

  const Step* step_ = nullptr;
  std::vector<Vec3> moves_;
  std::vector<BodyTwist> twists_;
  std::vector<ContactPair> blocked_;
  bool searched_ = false;  // all pairs within the slack of these places
  std::vector<Vec3> searched_nodes_, resting_;
  std::vector<BodyState> searched_bodies_;
  std::vector<BodyTwist> resting_bodies_;
  // Of each candidate: the share of the way that is free of contact, and lower bounds of its gap
  // anywhere on the way last looked along and at the place last evaluated. Bounds only save work:
  // where one does not decide, the distance itself does.
  std::vector<double> shares_, floors_, gaps_, kept_gaps_;
  std::vector<Vec3> evaluated_nodes_;  // the place last evaluated
  std::vector<BodyState> evaluated_bodies_;
  std::vector<double> node_ways_, body_ways_;  // bounds of the lengths of ways, m
  std::vector<char> is_near_;                  // whether each candidate is within the range
  std::vector<std::size_t> near_;              // those that are
  bool near_is_known_ = false;                 // at the place last evaluated
  std::vector<Term> terms_;
  std::vector<BodyPlace> body_places_;
  std::vector<Foretold> foretold_, next_foretold_;  // as the pairs are ordered
  std::vector<Sliding> sliding_, next_sliding_;
  std::vector<Vec3> no_turns_;            // of each body
  int rounds_ = 0, foretold_rounds_ = 0;  // of friction in this step
  double* search_time_ = nullptr;         // see begin()
  double force_round_off_ = 0.0;
};

}  // namespace retiarius
