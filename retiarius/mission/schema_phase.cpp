// The tables [[phase]] and [[phase.move]].
#include "retiarius/mission/schema.hpp"

namespace retiarius {

namespace {

// "none" in the file is the empty list of held nodes.
Key<PhaseSpec> fix_key() {
  auto k = key("fix", &PhaseSpec::fix, "",
               "nodes held where they are: none, corners, perimeter, or names of nodes");
  k.get = [](const PhaseSpec& spec) -> KeyValue {
    return spec.fix.empty() ? std::vector<std::string>{"none"} : spec.fix;
  };
  k.set = [](PhaseSpec& spec, const KeyValue& value) {
    spec.fix = std::get<std::vector<std::string>>(value);
    if (spec.fix == std::vector<std::string>{"none"}) spec.fix.clear();
  };
  return k;
}

// Closing waits one time for all corners; shooting may give one for each.
Key<PhaseSpec> closing_delay_key() {
  auto k = key("delay", &PhaseSpec::delay, "s", "before the corners leave").only_for({"close"});
  k.type = KeyType::number;
  k.get = [](const PhaseSpec& spec) -> KeyValue {
    return spec.delay.empty() ? 0.0 : spec.delay.front();
  };
  k.set = [](PhaseSpec& spec, const KeyValue& value) { spec.delay = {std::get<double>(value)}; };
  return k.at_least(0).or_else(0.0);
}

}  // namespace

const Table<PhaseSpec>& phase_table() {
  using List = std::vector<double>;
  static const Table<PhaseSpec> table(
      {"phase",
       "A stage of the mission, in order. [phase.environment], [phase.integrator] and "
       "[phase.contact] take the keys of the tables of these names and override them until the "
       "phase ends.",
       "kind",
       true,
       {"move", "environment", "integrator", "contact"}},
      {word("kind", &PhaseSpec::kind,
            {{"free", PhaseKind::free},
             {"fold", PhaseKind::fold},
             {"shoot", PhaseKind::shoot},
             {"spread", PhaseKind::spread},
             {"contact", PhaseKind::contact},
             {"close", PhaseKind::close}},
            "what the phase does")
           .must_be_given()
           .not_yet({"tug"}),
       key("name", &PhaseSpec::name, "", "in results")
           .else_used("the kind, numbered on repetition"),
       fix_key(),
       key("until", &PhaseSpec::until, "", "trigger that ends the phase; see Triggers")
           .must_be_given(),
       key("speed", &PhaseSpec::speed, "m/s", "of the corner masses; a list gives one per corner")
           .above(0)
           .must_be_given()
           .only_for({"shoot"}),
       key("half_angle_deg", &PhaseSpec::half_angle_deg, "deg",
           "of the corners' velocities from the axis; a list gives one per corner")
           .at_least(0)
           .up_to(90)
           .or_else(List{45.0})
           .only_for({"shoot"}),
       key("delay", &PhaseSpec::delay, "s",
           "until a corner leaves, held so long; a list gives one per corner")
           .at_least(0)
           .or_else(List{0.0})
           .only_for({"shoot"}),
       key("axis", &PhaseSpec::axis, "", "direction of the shot, of any length above zero")
           .only_for({"shoot"}),
       key("grips", &PhaseSpec::grips, "", "lattice, spokes, or names of nodes")
           .or_else(std::vector<std::string>{"lattice"})
           .only_for({"fold"}),
       key("grip_spacing", &PhaseSpec::grip_spacing, "m",
           "between neighbouring grips; to be given unless grips are named")
           .at_least(0)
           .only_for({"fold"}),
       key("ratio", &PhaseSpec::ratio, "", "final over initial distance between neighbouring grips")
           .above(0)
           .up_to(1)
           .only_for({"fold"}),
       key("duration", &PhaseSpec::duration, "s", "of the folding")
           .above(0)
           .must_be_given()
           .only_for({"fold"}),
       word("path", &PhaseSpec::path,
            {{"behind", ClosePath::behind}, {"straight", ClosePath::straight}},
            "of the corners: past the target, then inward, or straight to its centre")
           .only_for({"close"}),
       key("distance", &PhaseSpec::distance, "m",
           "behind the target's mass centre along the shot axis where the corners meet")
           .only_for({"close"}),
       key("radius", &PhaseSpec::radius, "m",
           "from the axis (straight: from the target's centre) where the corners stop")
           .at_least(0)
           .only_for({"close"}),
       key("speed", &PhaseSpec::close_speed, "m/s", "of the corners along their paths")
           .above(0)
           .only_for({"close"}),
       closing_delay_key()});
  return table;
}

const Table<MoveSpec>& move_table() {
  static const Table<MoveSpec> table(
      {"phase.move",
       "Prescribed motion of nodes, on top of what the phase does: by `displacement` within "
       "`duration`, smoothly, or at a constant `velocity` for `duration`; then held until the "
       "phase ends.",
       "",
       true,
       {}},
      {key("nodes", &MoveSpec::nodes, "", "names or indices of the nodes").must_be_given(),
       key("displacement", &MoveSpec::displacement, "m", "reached at the end; needs duration"),
       key("velocity", &MoveSpec::velocity, "m/s", "instead of displacement"),
       key("duration", &MoveSpec::duration, "s", "of the motion; inf: until the phase ends")
           .above(0)
           .or_infinite()});
  return table;
}

}  // namespace retiarius
