// Whether closed curves are linked, and how a curve crosses itself: what contact must not change.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/LU>

#include "retiarius/base/vec.hpp"

namespace retiarius::testing {

// Gauss's linking integral of two segments (a0-a1, b0-b1) over 4 pi: their signed solid angle,
// exact (Klenin and Langowski, "Computation of writhe in modeling of supercoiled DNA", Biopolymers
// 54 (2000), Eqs. 15 and 16).
inline double segment_linking(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
  const Vec3 r13 = b0 - a0, r14 = b1 - a0, r23 = b0 - a1, r24 = b1 - a1;
  const Vec3 n[4] = {r13.cross(r14), r14.cross(r24), r24.cross(r23), r23.cross(r13)};
  double angle = 0.0;
  for (int k = 0; k < 4; ++k) {
    const double size = n[k].norm() * n[(k + 1) % 4].norm();
    if (size == 0.0) return 0.0;  // in one plane
    angle += std::asin(std::clamp(n[k].dot(n[(k + 1) % 4]) / size, -1.0, 1.0));
  }
  const double side = (b1 - b0).cross(a1 - a0).dot(r13);
  return std::copysign(angle, side) / (4.0 * kPi);
}

inline std::vector<Vec3> places(const std::vector<Vec3>& x, const std::vector<Index>& nodes) {
  std::vector<Vec3> result;
  for (const Index i : nodes) result.push_back(x[static_cast<std::size_t>(i)]);
  return result;
}

// The linking number of two closed polygons without common points: whole but for round-off.
inline double linking_number(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      sum += segment_linking(a[i], a[(i + 1) % a.size()], b[j], b[(j + 1) % b.size()]);
  return sum;
}

// The number by which Alexander's polynomial at -1 tells knots apart: 1 for a curve that is not
// knotted, 3 for the trefoil that an overhand knot is once its ends are joined. The curve is given
// as a closed polygon, seen along -z after a small turn so that nothing is seen end on.
inline double knot_determinant(std::vector<Vec3> curve) {
  const Quat turn(Eigen::AngleAxisd(0.3, Vec3(0.6, -0.5, 0.62).normalized()));
  for (Vec3& p : curve) p = turn * p;
  const std::size_t n = curve.size();
  struct Crossing {
    double under, over;  // places along the curve, in segments
  };
  std::vector<Crossing> crossings;
  const auto at = [&](std::size_t k) { return curve[k % n]; };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      const Vec3 d = at(i + 1) - at(i), e = at(j + 1) - at(j), r = at(j) - at(i);
      const double area = d.x() * e.y() - d.y() * e.x();
      if (area == 0.0) continue;
      const double s = (r.x() * e.y() - r.y() * e.x()) / area;
      const double t = (r.x() * d.y() - r.y() * d.x()) / area;
      if (s < 0.0 || s >= 1.0 || t < 0.0 || t >= 1.0) continue;
      const double a = static_cast<double>(i) + s, b = static_cast<double>(j) + t;
      const bool first_over = at(i).z() + s * d.z() > at(j).z() + t * e.z();
      crossings.push_back(first_over ? Crossing{b, a} : Crossing{a, b});
    }
  }
  const std::size_t count = crossings.size();
  if (count < 2) return 1.0;
  // Arcs run from one passage below to the next; a colouring has 2 over = before + after at each.
  std::sort(crossings.begin(), crossings.end(),
            [](const Crossing& a, const Crossing& b) { return a.under < b.under; });
  const auto arc = [&](double place) {
    std::size_t k = 0;
    while (k < count && crossings[k].under <= place) ++k;
    return k % count;
  };
  const auto size = static_cast<Eigen::Index>(count);
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t k = 0; k < count; ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    m(row, static_cast<Eigen::Index>(arc(crossings[k].over))) += 2.0;
    m(row, static_cast<Eigen::Index>(k)) -= 1.0;
    m(row, static_cast<Eigen::Index>((k + 1) % count)) -= 1.0;
  }
  return std::abs(m.topLeftCorner(size - 1, size - 1).determinant());
}

}  // namespace retiarius::testing
