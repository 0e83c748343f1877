#include <cmath>
#include <numeric>
#include <utility>

#include "retiarius/net/layout.hpp"

namespace retiarius {
namespace {

// Knots of sector k are i u_k + j u_(k+1) with i >= 1, j >= 0, i + j <= n, where u_k reaches from
// the centre to the first knot of spoke k; the centre has number 0.
class Sectors {
 public:
  Sectors(int sides, std::int64_t n) : sides_(sides), n_(n) {}

  Index knot(std::int64_t sector, std::int64_t i, std::int64_t j) const {
    if (i == 0 && j == 0) return 0;
    if (i == 0) return knot(sector + 1, j, 0);
    const std::int64_t k = (sector + sides_) % sides_;
    const std::int64_t before = (i - 1) * (n_ + 1) - i * (i - 1) / 2;
    return static_cast<Index>(1 + k * (n_ * (n_ + 1) / 2) + before + j);
  }

 private:
  std::int64_t sides_, n_;
};

void place_knots(Layout& layout, int sides, double radius, std::int64_t n, double turn) {
  const auto corner = [&](int k) {
    const double angle = turn + 2.0 * kPi * k / sides;
    return Vec3(radius * std::cos(angle), radius * std::sin(angle), 0.0);
  };
  layout.nodes.push_back(Vec3::Zero());
  for (int k = 0; k < sides; ++k) {
    const Vec3 first = corner(k), second = corner((k + 1) % sides);
    for (std::int64_t i = 1; i <= n; ++i) {
      for (std::int64_t j = 0; i + j <= n; ++j) {
        layout.nodes.push_back((double(i) * first + double(j) * second) / double(n));
      }
    }
  }
}

void add_perimeter(Layout& layout, const Sectors& sectors, int sides, std::int64_t n,
                   double length) {
  for (int k = 0; k < sides; ++k) {
    std::vector<Index> nodes;
    for (std::int64_t t = 0; t <= n; ++t) nodes.push_back(sectors.knot(k, n - t, t));
    layout.corners.push_back(nodes.front());
    add_line(layout, std::move(nodes), length, true);
  }
  layout.outline.resize(layout.pieces.size());
  std::iota(layout.outline.begin(), layout.outline.end(), 0);
}

void add_spokes(Layout& layout, const Sectors& sectors, int sides, std::int64_t n, double length) {
  const bool through = sides % 2 == 0;
  for (int k = 0; k < (through ? sides / 2 : sides); ++k) {
    std::vector<Index> nodes;
    if (through) {
      for (std::int64_t i = n; i >= 1; --i) nodes.push_back(sectors.knot(k + sides / 2, i, 0));
    }
    for (std::int64_t i = 0; i <= n; ++i) nodes.push_back(sectors.knot(k, i, 0));
    add_line(layout, std::move(nodes), length, false);
  }
}

// The lines that start in the inner knots of one spoke: one into the sector on its left, one into
// that on its right. For four sides the two are collinear and so one thread.
void add_sector_lines(Layout& layout, const Sectors& sectors, int sides, std::int64_t n, int spoke,
                      double length) {
  for (std::int64_t j = 1; j < n; ++j) {
    std::vector<Index> right, left;
    for (std::int64_t i = 0; i <= n - j; ++i) {
      right.push_back(sectors.knot(spoke - 1, i, j));
      left.push_back(sectors.knot(spoke, j, i));
    }
    if (sides == 4) {
      std::vector<Index> whole(right.rbegin(), right.rend());
      whole.insert(whole.end(), left.begin() + 1, left.end());
      add_line(layout, std::move(whole), length, false);
    } else {
      add_line(layout, std::move(right), length, false);
      add_line(layout, std::move(left), length, false);
    }
  }
}

}  // namespace

Layout polygon_layout(int sides, double side, std::int64_t n, double turn) {
  // Rounding must not make the hexagon's spokes differ from its sides.
  const double radius = sides == 6 ? side : side / (2.0 * std::sin(kPi / sides));
  const Sectors sectors(sides, n);
  Layout layout;
  place_knots(layout, sides, radius, n, turn);
  add_perimeter(layout, sectors, sides, n, side / double(n));
  add_spokes(layout, sectors, sides, n, radius / double(n));
  for (int k = 0; k < sides; ++k) {
    add_sector_lines(layout, sectors, sides, n, k, radius / double(n));
  }
  return layout;
}

}  // namespace retiarius
