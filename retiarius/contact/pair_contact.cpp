#include "retiarius/base/error.hpp"
#include "retiarius/contact/barrier.hpp"

namespace retiarius {

void transfer(Archive& archive, PairContact& contact) {
  auto& [pair, places, place, weight, normal, point, gap, force, energy, point_force, friction,
         slip] = contact;
  auto& [kind, first_owner, first, second_owner, second] = pair;
  archive(kind, first_owner, first, second_owner, second);
  if (kind > PairKind::point_plane) throw Error("it has contacts of no kind");
  for (PointPlace& at : places) archive(at.owner, at.point);
  for (Vec3& at : place) archive(at);
  for (double& share : weight) archive(share);
  archive(normal, point, gap, force, energy);
  for (Vec3& on_point : point_force) archive(on_point);
  archive(friction, slip);
}

}  // namespace retiarius
