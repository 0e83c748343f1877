// The distances of random pairs against those in quadruple precision and against the bounds that
// the closest points and the normal prove.
#pragma once

#include <algorithm>

#include <gtest/gtest.h>

#include "retiarius/contact/distance.hpp"
#include "tests/contact/exact_distance.hpp"
#include "tests/contact/pair_samples.hpp"

namespace retiarius::testing {

struct DistanceErrors {
  double value = 0.0;    // against quadruple precision
  double primal = 0.0;   // the stated closest points against the stated distance
  double dual = 0.0;     // what the normal separates, below the stated distance
  double normal = 0.0;   // of the normal's length
  double weights = 0.0;  // their sum, and how far they leave [0, 1]
};

inline double extent(const PairPositions& p) {
  double size = 0.0;
  for (int i = 1; i < 4; ++i) size = std::max(size, (p[static_cast<std::size_t>(i)] - p[0]).norm());
  return size;
}

// Errors in terms of `unit`, the rounding of these positions.
inline DistanceErrors distance_errors(PairKind kind, const PairPositions& p) {
  const Distance at = distance(kind, p);
  const QuadPositions q = quad(p);
  const auto exact = static_cast<double>(exact_distance(kind, q));
  const int first = first_count(kind), count = point_count(kind);
  DistanceErrors out;
  out.value = std::abs(at.value - exact);
  QuadVec u;
  double sum = 0.0;
  Quad separated = 1e300;
  const QuadVec n(at.normal);
  for (int i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double w = at.weight[k];
    u = u + Quad(w) * (q[k] - q[0]);
    sum += w;
    out.weights = std::max({out.weights, i < first ? -w : w, std::abs(w) - 1.0});
    for (int j = first; i < first && j < count; ++j) {
      const Quad apart = n.dot(q[k] - q[static_cast<std::size_t>(j)]);
      if (apart < separated) separated = apart;
    }
  }
  out.primal = std::abs(static_cast<double>(root(u.dot(u))) - at.value);
  out.dual = at.value - static_cast<double>(separated);
  out.normal = std::abs(at.normal.norm() - 1.0);
  out.weights = std::max(out.weights, std::abs(sum));
  return out;
}

// By how much the distance of edges at angles below 1e-10 may be too large: it is that of an end.
inline double parallel_allowance(PairKind kind, const PairPositions& p) {
  if (kind != PairKind::edge_edge) return 0.0;
  const Vec3 a = p[1] - p[0], b = p[3] - p[2];
  const double across = a.cross(b).norm(), scale = a.norm() * b.norm();
  if (!(across < 1.01e-10 * scale)) return 0.0;
  const double drift = across / scale * extent(p);
  return std::min(drift, drift * drift / (2.0 * distance(kind, p).value));
}

inline void check_random_distances(std::uint64_t seed, int count) {
  Stream random(seed);
  for (int k = 0; k < count; ++k) {
    const PairPositions p = sample_pair(random);
    for (const PairKind kind : kBoundedKinds) {
      const DistanceErrors errors = distance_errors(kind, p);
      const double size = extent(p);
      const double bound = 1e-15 * size + 1e-300;
      const double allowed = 8.0 * bound + parallel_allowance(kind, p);
      ASSERT_LE(errors.value, allowed) << "sample " << k << " kind " << static_cast<int>(kind);
      ASSERT_LE(errors.primal, 8.0 * bound) << "sample " << k << " kind " << static_cast<int>(kind);
      ASSERT_LE(errors.normal, 1e-15);
      ASSERT_LE(errors.weights, 1e-15);
      // The normal is known to rounding over distance.
      const double value = distance(kind, p).value;
      if (value > 1e-9 * size) {
        ASSERT_LE(errors.dual, 40.0 * bound * size / value)
            << "sample " << k << " kind " << static_cast<int>(kind);
      }
    }
  }
}

}  // namespace retiarius::testing
