// The analytic shapes. All lengths in m, positive and finite (checked by build_shape); the origin
// is the mass centre. Where the nearest point is not unique, the answer is a fixed one of them, as
// documented here, and its normal is a subgradient of the distance.
#pragma once

#include <memory>

#include "retiarius/bodies/shape.hpp"

namespace retiarius {

// Normal at the centre: +z.
std::shared_ptr<const Shape> make_sphere(double radius);

// Edges along x, y, z. Inside, of equally near faces the one with the lowest axis counts, and of
// opposite ones the positive.
std::shared_ptr<const Shape> make_box(const Vec3& size);

// Axis along z. On the axis the radial direction is +x; of equally near faces the base counts
// before the side, the side before the top.
std::shared_ptr<const Shape> make_cylinder(double radius, double length);

// `length` lies between the centres of the caps, which are at z = -length/2 and +length/2. On the
// axis between them the normal is +x.
std::shared_ptr<const Shape> make_capsule(double radius, double length);

// Apex at z = +3/4 length, base at z = -1/4 length. On the axis the radial direction is +x; of
// equally near faces the base counts before the side.
std::shared_ptr<const Shape> make_cone(double radius, double length);

// The half space z <= 0. Volume, area and bounding radius are infinite, the inertia is zero and
// without meaning; triangles() is an open square of 20 m, for drawing.
std::shared_ptr<const Shape> make_plane();

}  // namespace retiarius
