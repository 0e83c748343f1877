// The tables [environment], [integrator], [contact], [[probe]] and [output].
#include "retiarius/mission/schema.hpp"

namespace retiarius {

const Table<EnvironmentSpec>& environment_table() {
  static const Table<EnvironmentSpec> table(
      {"environment", "What surrounds the net. A phase may override it.", "", false, {}},
      {key("gravity", &EnvironmentSpec::gravity, "m/s2", "acceleration of free fall"),
       key("damping", &EnvironmentSpec::damping, "1/s", "environmental: force -damping m v")
           .at_least(0)});
  return table;
}

const Table<IntegratorSpec>& integrator_table() {
  static const Table<IntegratorSpec> table(
      {"integrator", "How time is stepped. A phase may override it.", "", false, {}},
      {word(
           "method", &IntegratorSpec::method,
           {{"implicit-euler", Method::implicit_euler},
            {"newmark", Method::newmark},
            {"midpoint", Method::midpoint},
            {"generalised-alpha", Method::generalised_alpha},
            {"tr-bdf2", Method::tr_bdf2},
            {"explicit", Method::explicit_differences},
            {"static", Method::static_solve},
            {"auto", Method::automatic}},
           "implicit Euler (damps), Newmark with average acceleration, implicit midpoint, "
           "generalised alpha and TR-BDF2 (damp only what the step does not resolve), explicit "
           "central differences in sub-steps (for stiff nets of few segments a piece), or the "
           "static equilibrium; auto takes explicit where its sub-steps are predicted to cost less "
           "than steps of implicit Euler of like accuracy, else implicit Euler (adaptive, threads "
           "that carry compression: TR-BDF2)"),
       word("solver", &IntegratorSpec::solver,
            {{"auto", Solver::automatic},
             {"direct", Solver::direct},
             {"reuse", Solver::reuse},
             {"pcg", Solver::pcg}},
            "how the equations of a step are solved: with a new factorisation for every iteration "
            "(direct), with one kept while it serves (reuse), or by preconditioned conjugate "
            "gradients (pcg: for soft nets and short steps); auto takes pcg where the counts tell "
            "that it is quicker, else reuse where all threads carry compression"),
       word("newton", &IntegratorSpec::newton,
            {{"converged", Newton::converged}, {"single", Newton::single}},
            "implicit only: iterate each step until tolerance is met, or take one Newton update "
            "and go on (linearly implicit, for real time: steps are not converged; implicit Euler, "
            "threads that carry compression, no contact)"),
       key("step", &IntegratorSpec::step, "s",
           "h; divides output.interval. Adaptive: the largest, which need not divide it")
           .above(0),
       key("substep", &IntegratorSpec::substep, "s",
           "explicit only: the longest sub-step; each step is cut into equal ones below it and "
           "below nine tenths of the stable step; 0: that alone")
           .at_least(0),
       key("rho", &IntegratorSpec::rho, "",
           "spectral radius of generalised alpha at infinite frequency: 1 damps nothing, 0 all "
           "that is not resolved")
           .at_least(0)
           .up_to(1),
       key("adaptive", &IntegratorSpec::adaptive, "",
           "the step follows the local error, and ends on output rows and the phase's events"),
       key("accuracy", &IntegratorSpec::accuracy, "",
           "of adaptive steps: the local error of one step that is allowed, root mean square over "
           "the nodes' positions, over the median rest length")
           .above(0)
           .up_to(1),
       key("min_step", &IntegratorSpec::min_step, "s",
           "the shortest adaptive step; 0: a thousandth of step")
           .at_least(0),
       key("tolerance", &IntegratorSpec::tolerance, "",
           "of Newton's iteration: of moves over the median rest length and of forces over the "
           "largest force")
           .above(0)
           .up_to(0.1),
       key("max_iterations", &IntegratorSpec::max_iterations, "",
           "Newton iterations of one step before it is halved")
           .at_least(1)
           .up_to(1e6),
       key("max_halvings", &IntegratorSpec::max_halvings, "", "of a step before the run fails")
           .at_least(0)
           .up_to(60)});
  return table;
}

const Table<ContactSpec>& contact_table() {
  static const Table<ContactSpec> table(
      {"contact",
       "What follows when threads touch bodies, or each other. A phase may override it.",
       "",
       false,
       {}},
      {word("method", &ContactSpec::method,
            {{"none", ContactMethod::none},
             {"modified-mass", ContactMethod::modified_mass},
             {"barrier", ContactMethod::barrier}},
            "of the response: none, modified mass at nodes with the thread's radius, or barriers "
            "around whole threads and bodies, which never interpenetrate"),
       key("friction", &ContactSpec::friction, "",
           "Coulomb's coefficient, thread on body and body on body")
           .at_least(0),
       key("self", &ContactSpec::self, "", "contact of thread on thread; needs barrier"),
       key("thread_friction", &ContactSpec::thread_friction, "",
           "barrier only: Coulomb's coefficient, thread on thread")
           .at_least(0),
       key("gap", &ContactSpec::gap, "m",
           "barrier only: how far from each other surfaces begin to push; 0: a quarter of the "
           "thinnest "
           "thread's radius")
           .at_least(0),
       key("stick_speed", &ContactSpec::stick_speed, "m/s",
           "barrier only: below it friction falls with the speed of slip, so that it is smooth")
           .above(0),
       key("friction_rounds", &ContactSpec::friction_rounds, "",
           "barrier only: a step is solved at most so often for the normal forces that friction "
           "goes by, and takes those foretold on the way to a solution at most as often")
           .at_least(1)
           .up_to(1000),
       key("friction_tolerance", &ContactSpec::friction_tolerance, "",
           "relative change of the normal forces below which a step is not solved again for them")
           .above(0)
           .up_to(1)});
  return table;
}

const Table<ProbeSpec>& probe_table() {
  static const Table<ProbeSpec> table(
      {"probe", "A node whose position and support force the history lists.", "", true, {}},
      {key("name", &ProbeSpec::name, "", "of the columns NAME.x, NAME.y, ...: letters, digits, _ -")
           .else_used("the node's"),
       key("node", &ProbeSpec::node, "", "center, corner0, corner1, ..., or an index")
           .of_type(KeyType::node)
           .must_be_given()});
  return table;
}

const Table<OutputSpec>& output_table() {
  static const Table<OutputSpec> table(
      {"output", "When results are written.", "", false, {}},
      {key("interval", &OutputSpec::interval, "s",
           "between rows of the history; a multiple of the step unless that is adaptive")
           .above(0),
       key("frame_interval", &OutputSpec::frame_interval, "s",
           "between frames; a multiple of interval")
           .above(0),
       key("every_step", &OutputSpec::every_step, "",
           "a frame of every accepted step as well, halved ones included: what check-contact looks "
           "at")});
  return table;
}

}  // namespace retiarius
