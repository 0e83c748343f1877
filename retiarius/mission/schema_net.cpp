// The tables [net], [net.thread], [net.border] and [net.corner_mass].
#include "retiarius/mission/schema.hpp"

namespace retiarius {

const Table<NetSpec>& net_table() {
  const std::vector<std::string> regular = {"hexagon", "square", "triangle", "polygon"};
  static const Table<NetSpec> table(
      {"net",
       "The net as designed: flat in its xy-plane, centre at the origin.",
       "pattern",
       false,
       {"thread", "border", "corner_mass"}},
      {word("pattern", &NetSpec::pattern,
            {{"hexagon", Pattern::hexagon},
             {"square", Pattern::square},
             {"triangle", Pattern::triangle},
             {"polygon", Pattern::polygon},
             {"file", Pattern::file}},
            "outline and mesh of the net; file: read from `file`")
           .must_be_given(),
       key("sides", &NetSpec::sides, "", "corners of the polygon")
           .at_least(3)
           .up_to(1000)
           .only_for({"polygon"}),
       key("side", &NetSpec::side, "m", "length of one side of the outline")
           .above(0)
           .must_be_given()
           .only_for(regular),
       key("mesh", &NetSpec::mesh, "m", "distance from knot to knot; divides the side")
           .above(0)
           .must_be_given()
           .only_for(regular),
       word("cell", &NetSpec::cell,
            {{"natural", Cell::natural}, {"square", Cell::square}, {"diamond", Cell::diamond}},
            "mesh: the pattern's own, square (along the sides; pattern square only), or diamond "
            "(square: at 45 degrees; triangle: two families of threads)")
           .only_for({"square", "triangle"}),
       key("segments", &NetSpec::segments, "", "segments per piece of thread between knots")
           .at_least(1)
           .up_to(1e6)
           .only_for(regular),
       word("knots", &NetSpec::knots,
            {{"continuous", Knots::continuous}, {"hinged", Knots::hinged}},
            "whether threads bend through their knots or are hinged there"),
       key("knot_mass", &NetSpec::knot_mass, "kg", "added at each knot").at_least(0),
       key("scale", &NetSpec::scale, "",
           "of the initial positions in the net's plane about its centre; rest lengths stay")
           .above(0),
       key("zigzag", &NetSpec::zigzag, "",
           "with scale below 1: nodes at odd graph distance from corner0 are lifted so that each "
           "segment keeps its rest length"),
       key("disturbance", &NetSpec::disturbance, "m",
           "largest random displacement of the start, from the mission's seed")
           .at_least(0),
       key("file", &NetSpec::file, "", "network file: nodes, segments, threads")
           .must_be_given()
           .only_for({"file"})
           .file_path(),
       key("state", &NetSpec::state, "",
           "folder of a run, or its checkpoint, that gives the initial positions")
           .file_path(),
       key("position", &NetSpec::position, "m", "where the net's centre is placed")});
  return table;
}

const Table<ThreadSpec>& thread_table() {
  static const Table<ThreadSpec> table(
      {"net.thread", "Material and cross-section of the threads.", "", false, {}},
      {key("young_modulus", &ThreadSpec::young_modulus, "Pa", "E").above(0).must_be_given(),
       key("density", &ThreadSpec::density, "kg/m3", "rho").above(0).must_be_given(),
       key("radius", &ThreadSpec::radius, "m", "of the circular cross-section, r0")
           .above(0)
           .must_be_given(),
       word("bending", &ThreadSpec::bending,
            {{"none", Bending::none}, {"bounded", Bending::bounded}, {"tangent", Bending::tangent}},
            "curvature of the bending energy: 2 sin(phi/2) or 2 tan(phi/2) over the joint's "
            "length, phi the turning angle"),
       key("bending_stiffness", &ThreadSpec::bending_stiffness, "N m2", "EI")
           .at_least(0)
           .else_used("solid rod, E pi r0^4 / 4"),
       key("compression", &ThreadSpec::compression, "",
           "whether threads resist compression; false: tension-only"),
       key("material_damping", &ThreadSpec::material_damping, "s",
           "tau of T = EA (eps + tau d(eps)/dt)")
           .at_least(0),
       key("strength", &ThreadSpec::strength, "N",
           "breaking tension; when exceeded the run says so")
           .above(0)
           .else_used("unlimited")});
  return table;
}

const Table<BorderSpec>& border_table() {
  const std::string same = "the thread's";
  static const Table<BorderSpec> table(
      {"net.border", "What differs on the perimeter threads.", "", false, {}},
      {key("young_modulus", &BorderSpec::young_modulus, "Pa", "E").above(0).else_used(same),
       key("density", &BorderSpec::density, "kg/m3", "rho").above(0).else_used(same),
       key("radius", &BorderSpec::radius, "m", "r0").above(0).else_used(same),
       key("bending_stiffness", &BorderSpec::bending_stiffness, "N m2", "EI")
           .at_least(0)
           .else_used("the thread's if given, else that of a solid rod"),
       key("strength", &BorderSpec::strength, "N", "breaking tension").above(0).else_used(same)});
  return table;
}

const Table<CornerMassSpec>& corner_mass_table() {
  static const Table<CornerMassSpec> table(
      {"net.corner_mass", "The bullets by which the net is shot.", "", false, {}},
      {key("mass", &CornerMassSpec::mass, "kg", "added at each corner").at_least(0),
       key("bridle", &CornerMassSpec::bridle, "m",
           "length of the line between corner and mass; 0: fixed to the corner")
           .at_least(0),
       key("bridle_segments", &CornerMassSpec::bridle_segments, "", "segments of each bridle")
           .at_least(1)
           .up_to(1e6)});
  return table;
}

}  // namespace retiarius
