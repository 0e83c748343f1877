// Patterns and matrices that the tests of this room share.
#pragma once

#include <cmath>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "retiarius/base/block_matrix.hpp"

namespace retiarius::test {

inline BlockPattern pattern_of(Index blocks, const std::vector<std::pair<Index, Index>>& pairs) {
  BlockPattern pattern(blocks);
  for (const auto& [i, j] : pairs) pattern.couple(i, j);
  pattern.finish();
  return pattern;
}

// Each block is coupled to those at most `reach` away.
inline BlockPattern chain(Index blocks, Index reach = 1) {
  std::vector<std::pair<Index, Index>> pairs;
  for (Index i = 0; i < blocks; ++i) {
    for (Index d = 1; d <= reach && i + d < blocks; ++d) pairs.emplace_back(i, i + d);
  }
  return pattern_of(blocks, pairs);
}

inline BlockPattern star(Index blocks, Index middle) {
  std::vector<std::pair<Index, Index>> pairs;
  for (Index i = 0; i < blocks; ++i) pairs.emplace_back(middle, i);
  return pattern_of(blocks, pairs);
}

inline BlockPattern grid(Index nx, Index ny) {
  std::vector<std::pair<Index, Index>> pairs;
  for (Index y = 0; y < ny; ++y) {
    for (Index x = 0; x < nx; ++x) {
      if (x + 1 < nx) pairs.emplace_back(y * nx + x, y * nx + x + 1);
      if (y + 1 < ny) pairs.emplace_back(y * nx + x, (y + 1) * nx + x);
    }
  }
  return pattern_of(nx * ny, pairs);
}

inline BlockPattern random_pattern(Index blocks, int pairs, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_int_distribution<Index> any(0, blocks - 1);
  BlockPattern pattern(blocks);
  for (int k = 0; k < pairs; ++k) {
    const Index i = any(generator);
    pattern.couple(i, any(generator));
  }
  pattern.finish();
  return pattern;
}

// A hexagon of triangular cells, `meshes` a side, each piece cut into `segments`, with couplings
// over one and two segments along the threads, as bending makes them: through knots, within pieces
// only, or none over two.
enum class Bend { across, hinged, none };
inline BlockPattern hexagon_net(int meshes, int segments, Bend bend = Bend::across) {
  const auto inside = [meshes](int q, int r) {
    return std::abs(q) <= meshes && std::abs(r) <= meshes && std::abs(q + r) <= meshes;
  };
  std::map<std::pair<int, int>, Index> knots;
  Index count = 0;
  for (int q = -meshes; q <= meshes; ++q) {
    for (int r = -meshes; r <= meshes; ++r) {
      if (inside(q, r)) knots[{q, r}] = count++;
    }
  }
  std::vector<std::pair<Index, Index>> pairs;
  for (const auto& [dq, dr] : {std::pair{1, 0}, std::pair{0, 1}, std::pair{1, -1}}) {
    for (const auto& [place, knot] : knots) {
      auto [q, r] = place;
      if (inside(q - dq, r - dr)) continue;
      std::vector<Index> thread{knot};
      for (; inside(q + dq, r + dr); q += dq, r += dr) {
        for (int i = 1; i < segments; ++i) thread.push_back(count++);
        thread.push_back(knots[{q + dq, r + dr}]);
      }
      for (std::size_t i = 0; i + 1 < thread.size(); ++i) {
        pairs.emplace_back(thread[i], thread[i + 1]);
        if (bend == Bend::none) continue;
        if (bend == Bend::hinged && static_cast<int>(i + 1) % segments == 0) continue;
        if (i + 2 < thread.size()) pairs.emplace_back(thread[i], thread[i + 2]);
      }
    }
  }
  return pattern_of(count, pairs);
}

// Blocks without symmetry of their own, so that a block put in transposed is noticed. Positive
// definite by diagonal dominance.
inline BlockMatrix random_matrix(const BlockPattern& pattern, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> entry(-1.0, 1.0);
  const auto block = [&] {
    Mat3 b;
    for (int k = 0; k < 9; ++k) b(k / 3, k % 3) = entry(generator);
    return b;
  };
  BlockMatrix matrix;
  matrix.reset(pattern);
  for (Mat3& d : matrix.diagonal) {
    const Mat3 b = block();
    d = b * b.transpose() + 0.5 * Mat3::Identity();
  }
  for (Index c = 0; c < pattern.blocks(); ++c) {
    for (Index k = pattern.starts()[c]; k < pattern.starts()[c + 1]; ++k) {
      matrix.below[k] = block();
      matrix.diagonal[c] += 3.0 * Mat3::Identity();
      matrix.diagonal[pattern.rows()[k]] += 3.0 * Mat3::Identity();
    }
  }
  return matrix;
}

inline std::vector<Vec3> random_vector(Index blocks, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> entry(-1.0, 1.0);
  std::vector<Vec3> x(static_cast<std::size_t>(blocks));
  for (Vec3& v : x) v = Vec3(entry(generator), entry(generator), entry(generator));
  return x;
}

inline double distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double squares = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) squares += (a[i] - b[i]).squaredNorm();
  return std::sqrt(squares);
}

inline double norm(const std::vector<Vec3>& a) {
  return distance(a, std::vector<Vec3>(a.size(), Vec3::Zero()));
}

struct NamedPattern {
  std::string name;
  BlockPattern pattern;
};

// Structures of every kind, small enough for a reference.
inline std::vector<NamedPattern> all_patterns() {
  return {{"empty", pattern_of(0, {})},
          {"single", pattern_of(1, {})},
          {"pair", chain(2)},
          {"triple", chain(3)},
          {"two of three", pattern_of(3, {{0, 2}})},
          {"uncoupled", pattern_of(20, {})},
          {"four", chain(4, 3)},
          {"short chain", chain(7)},
          {"chain", chain(300)},
          {"wide chain", chain(200, 2)},
          {"star, middle first", star(60, 0)},
          {"star, middle last", star(60, 59)},
          {"grid", grid(17, 23)},
          {"long grid", grid(200, 5)},
          {"dense 10", chain(10, 9)},
          {"dense 40", chain(40, 39)},
          {"dense 75", chain(75, 74)},
          {"sparse parts", random_pattern(200, 90, 1)},
          {"random", random_pattern(150, 400, 2)},
          {"random, dense", random_pattern(120, 2500, 3)},
          {"net 2,1", hexagon_net(2, 1)},
          {"net 3,4", hexagon_net(3, 4)},
          {"net 6,3", hexagon_net(6, 3)},
          {"net 2,20", hexagon_net(2, 20)},
          {"hinged net 3,10", hexagon_net(3, 10, Bend::hinged)},
          {"hinged net 4,4", hexagon_net(4, 4, Bend::hinged)},
          {"hinged net 5,2", hexagon_net(5, 2, Bend::hinged)},
          {"net without bending 3,6", hexagon_net(3, 6, Bend::none)},
          {"net without bending 6,1", hexagon_net(6, 1, Bend::none)}};
}

}  // namespace retiarius::test
