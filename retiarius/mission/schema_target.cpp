// The table [target] or [[target]].
#include "retiarius/mission/schema.hpp"

namespace retiarius {

const Table<BodySpec>& target_table() {
  const std::vector<std::string> solid = {"sphere", "box", "cylinder", "capsule", "cone", "mesh"};
  static const Table<BodySpec> table(
      {"target",
       "A rigid body. None by default; [[target]] gives several, [target] is target[0].",
       "shape",
       true,
       {}},
      {word("shape", &BodySpec::shape,
            {{"sphere", ShapeKind::sphere},
             {"box", ShapeKind::box},
             {"cylinder", ShapeKind::cylinder},
             {"capsule", ShapeKind::capsule},
             {"cone", ShapeKind::cone},
             {"plane", ShapeKind::plane},
             {"mesh", ShapeKind::mesh}},
            "of the surface; axes along body z, a plane's normal too")
           .must_be_given(),
       key("name", &BodySpec::name, "", "in results")
           .else_used("target, then target1, target2, ..."),
       key("radius", &BodySpec::radius, "m", "of sphere, cylinder, capsule, or the cone's base")
           .above(0)
           .must_be_given()
           .only_for({"sphere", "cylinder", "capsule", "cone"}),
       key("length", &BodySpec::length, "m",
           "along body z; capsule: between the centres of its caps; cone: its height")
           .above(0)
           .must_be_given()
           .only_for({"cylinder", "capsule", "cone"}),
       key("size", &BodySpec::size, "m", "edges along body x, y, z")
           .above(0)
           .must_be_given()
           .only_for({"box"}),
       key("file", &BodySpec::file, "", "closed triangle mesh, STL or OBJ")
           .must_be_given()
           .only_for({"mesh"})
           .file_path(),
       key("scale", &BodySpec::scale, "", "from the mesh file's units to metres")
           .above(0)
           .only_for({"mesh"}),
       key("mass", &BodySpec::mass, "kg", "of the body; a free body needs this or density")
           .above(0)
           .only_for(solid)
           .else_used("from density"),
       key("density", &BodySpec::density, "kg/m3", "mass from volume, instead of mass")
           .above(0)
           .only_for(solid)
           .else_used("from mass"),
       key("inertia", &BodySpec::inertia, "kg m2", "principal moments, along body axes")
           .above(0)
           .only_for(solid)
           .else_used("of the homogeneous solid"),
       word("motion", &BodySpec::motion, {{"free", BodyMotion::free}, {"fixed", BodyMotion::fixed}},
            "whether forces move it; a plane is fixed"),
       key("position", &BodySpec::position, "m", "of the mass centre; plane: of a point of it"),
       key("attitude_deg", &BodySpec::attitude_deg, "deg", "rotation vector from body to world"),
       key("velocity", &BodySpec::velocity, "m/s", "of the mass centre, at the start"),
       key("spin_deg", &BodySpec::spin_deg, "deg/s", "about body axes, at the start"),
       key("friction", &BodySpec::friction, "",
           "Coulomb's coefficient of its surface, with barriers; between two bodies the mean of "
           "theirs")
           .at_least(0)
           .else_used("contact.friction")});
  return table;
}

}  // namespace retiarius
