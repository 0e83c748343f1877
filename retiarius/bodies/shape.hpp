// The surface of a rigid body, in body axes with the mass centre at the origin.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "retiarius/base/vec.hpp"
#include "retiarius/bodies/spec.hpp"

namespace retiarius {

// The answer to "how far is this point from the surface": negative inside.
struct SurfacePoint {
  double distance = kInfinity;  // signed, m
  Vec3 normal = Vec3::UnitZ();  // unit, outward; gradient of the distance where it exists
  Vec3 point = Vec3::Zero();    // the nearest point of the surface
};

// Triangles for drawing, area sampling and files.
struct TriangleMesh {
  std::vector<Vec3> vertices;
  std::vector<std::array<Index, 3>> triangles;  // counter-clockwise seen from outside
};

// Volume, mass centre and inertia of a homogeneous solid of unit density.
struct SolidProperties {
  double volume = 0.0;          // m3
  Vec3 center = Vec3::Zero();   // m
  Mat3 inertia = Mat3::Zero();  // about the centre, per unit density, m5
};

class Shape {
 public:
  virtual ~Shape() = default;

  // Signed distance, normal and nearest surface point of a point in body axes.
  virtual SurfacePoint nearest(const Vec3& point) const = 0;

  // Smallest signed distance from the points of the straight segment a-b to the surface: exact to
  // round-off for sphere and plane, within 1e-12 of the lengths involved for the other analytic
  // shapes, within 1e-7 of the segment's length for a mesh.
  virtual double segment_distance(const Vec3& a, const Vec3& b) const = 0;

  // Radius of the smallest sphere about the origin that holds the shape; infinity for a plane.
  virtual double bounding_radius() const = 0;

  // For a plane the volume is infinite and the inertia has no meaning.
  virtual SolidProperties solid() const = 0;
  virtual double surface_area() const = 0;

  // A closed triangle surface that lies within a thousandth of the size (diameter) of the true
  // one; for a plane an open square of 20 m.
  virtual TriangleMesh triangles() const = 0;
};

// Builds the shape of a spec. A mesh is moved so that its mass centre is the origin; `offset` is
// where the origin of the file lies then. Throws InputError naming what is wrong (a mesh that is
// not closed names an open edge, ...). Relative files are sought in `folder`.
struct ShapeInBody {
  std::shared_ptr<const Shape> shape;
  Vec3 offset = Vec3::Zero();
};
ShapeInBody build_shape(const BodySpec& spec, const std::string& folder);

}  // namespace retiarius
