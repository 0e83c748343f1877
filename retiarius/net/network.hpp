// What a net is: nodes joined by segments of thread, joints where threads bend, named places.
// Immutable once built; everything that moves is in State.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "retiarius/base/vec.hpp"
#include "retiarius/net/spec.hpp"

namespace retiarius {

// A thread's cross-section and material, with the stiffnesses that the laws use.
struct Material {
  double young_modulus = 0.0;      // E, Pa
  double density = 0.0;            // rho, kg/m3
  double radius = 0.0;             // r0, m
  double axial_stiffness = 0.0;    // EA, N
  double bending_stiffness = 0.0;  // EI, N m2; 0 where bending is none
  Bending bending = Bending::none;
  bool compression = true;
  double damping = 0.0;         // tau, s
  double strength = kInfinity;  // N
  double line_density = 0.0;    // rho A, kg/m
};

struct Segment {
  Index a = kNone, b = kNone;  // its nodes
  double rest_length = 0.0;    // l0, m
  Index material = 0;          // into Network::materials
  Index thread = kNone;        // into Network::threads
};

// Two consecutive segments of one thread meeting in node b: a-b and b-c.
struct Joint {
  Index a = kNone, b = kNone, c = kNone;
  Index first = kNone, second = kNone;  // segments a-b and b-c
  double voronoi_length = 0.0;          // (l0_1 + l0_2) / 2, m
  double bending_stiffness = 0.0;       // EI, N m2 (the mean of its two segments)
};

// A whole straight line of pieces through the net, from end to end. A closed thread repeats its
// first node at the end.
struct Thread {
  std::vector<Index> nodes;
  std::vector<Index> segments;
  bool perimeter = false;
};

struct Network {
  std::vector<Vec3> design;    // node positions as designed: flat, centre at the origin, scale 1
  std::vector<Vec3> initial;   // node positions at the mission's start
  std::vector<Vec3> velocity;  // node velocities at the mission's start
  std::vector<double> mass;    // kg, lumped: threads, knots and corner masses
  std::vector<Segment> segments;
  std::vector<Joint> joints;
  std::vector<Thread> threads;
  std::vector<Material> materials;
  std::vector<Index> knots;    // nodes in which threads cross or end, ascending
  std::vector<Index> corners;  // the mouth's polygon, counter-clockwise from +x seen from +z
  std::vector<Index> bullets;  // the nodes of the corner masses (the corners without bridle)
  // All nodes of the outline in order, counter-clockwise from corner 0.
  std::vector<Index> perimeter;
  Index center = kNone;         // the knot nearest the centroid
  Vec3 normal = Vec3::UnitZ();  // of the net as designed

  Index node_count() const { return static_cast<Index>(design.size()); }
  Index segment_count() const { return static_cast<Index>(segments.size()); }
};

// Builds the network that a spec describes: pattern, pieces, joints, masses, bridles, initial
// positions (scale, zigzag, place), but neither `disturbance` nor `state`, which the mission
// applies. Throws InputError naming the key, its value and the remedy.
Network build_network(const NetSpec& spec);

// Counts that a build would give, without building it: cheap for any size.
struct NetworkCounts {
  double nodes = 0, segments = 0, joints = 0, knots = 0;
};
NetworkCounts count_network(const NetSpec& spec);

// The nodes that a name selects: "none", "all", "corners", "bullets", "perimeter", "knots",
// "center", "corner3", "bullet0", or a decimal index. Throws InputError that lists the names.
std::vector<Index> select_nodes(const Network& network, std::string_view name);

// Median rest length of the segments, m: the length scale of the convergence test.
double median_rest_length(const Network& network);

// Checks everything the laws rely on: finite positions, positive masses, rest lengths and
// stiffnesses, indices in range, joints that join their segments. Throws Error naming the culprit.
void validate(const Network& network);

}  // namespace retiarius
