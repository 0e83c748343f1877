// From where a picture is taken.
#pragma once

#include <string>
#include <vector>

#include "retiarius/base/vec.hpp"

namespace retiarius::render {

// iso: from the right and above, +z up; front: from -y; side: from +x, both with +z up; top: from
// +z, with +y up.
enum class View { iso, front, side, top };

const std::vector<std::string>& view_names();
// Throws InputError that lists the names.
View view_named(const std::string& name);

// A part of the paper; units of the picture (pixels, points), y downwards.
struct Area {
  double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
};

// A point on paper.
struct Place {
  double x = 0.0, y = 0.0;
  double depth = 0.0;  // distance from the camera along its axis, m
  double scale = 0.0;  // units of the picture a metre at this depth
};

// Perspective from 3.4 radii of the sphere about the points' box, so placed that all points lie
// within the area and fill it in one direction.
class Camera {
 public:
  Camera(View view, const std::vector<Vec3>& points, const Area& area);

  Place place(const Vec3& x) const;

  Vec3 towards(const Vec3& x) const { return (eye_ - x).normalized(); }
  Vec3 lamp() const;  // unit vector to the lamp, above the viewer's left shoulder
  const Vec3& right() const { return right_; }
  const Vec3& up() const { return up_; }
  double middle_depth() const { return distance_; }           // of the points' centre, m
  double middle_scale() const { return focal_ / distance_; }  // units a metre there
  double radius() const { return radius_; }                   // of the points' sphere, m

 private:
  Vec3 right_, up_, axis_;  // axis_ points to the viewer
  Vec3 eye_;
  double radius_ = 1.0, distance_ = 1.0;
  double focal_ = 1.0;        // units of the picture
  double x_ = 0.0, y_ = 0.0;  // where the axis meets the paper
};

}  // namespace retiarius::render
