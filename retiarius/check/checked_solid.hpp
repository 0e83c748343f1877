// The region that a body fills, for checking alone.
#pragma once

#include <memory>
#include <vector>

#include "retiarius/bodies/shape.hpp"
#include "retiarius/bodies/spec.hpp"

namespace retiarius::check {

class CheckedSolid {
 public:
  virtual ~CheckedSolid() = default;

  // Radius about the mass centre that holds it, m; infinite for a plane.
  virtual double radius() const = 0;

  // The smallest signed distance (negative inside, m) from the places of the straight segment a-b,
  // in body axes, to the surface; where it is at least `enough`, any number from `enough` on.
  // Inside a mesh it is that of the deepest of 33 places.
  virtual double distance(const Vec3& a, const Vec3& b, double enough) const = 0;

  // The part of the surface in a box, for many segments within it: saves a pass over all of it.
  struct Near {
    bool nothing = false;          // it holds no surface
    std::vector<Index> triangles;  // of a mesh
  };
  virtual Near near(const Vec3& low, const Vec3& high) const = 0;

  // The same by this part alone, for a segment that comes from outside: where it is nowhere nearer
  // to the surface than `enough` it counts as outside.
  virtual double distance(const Near& near, const Vec3& a, const Vec3& b, double enough) const = 0;
};

// From what the mission says; a mesh from the triangles that the run recorded, in body axes.
std::unique_ptr<CheckedSolid> checked_solid(const BodySpec& spec, const TriangleMesh& recorded);

}  // namespace retiarius::check
