// What a mission says about contact ([contact]): plain data.
#pragma once

namespace retiarius {

enum class ContactMethod { none, modified_mass, barrier };

struct ContactSpec {
  ContactMethod method = ContactMethod::none;
  double friction = 0.0;  // Coulomb coefficient, thread on body
  // A step is solved again until the normal forces that friction goes by change by no more than
  // this share.
  double friction_tolerance = 1e-2;
  bool self = false;  // thread on thread; barrier only

  // Of the barrier alone.
  double thread_friction = 0.0;  // Coulomb coefficient, thread on thread
  double gap = 0.0;              // range of the barrier, m; 0: a quarter of the thinnest radius
  double stick_speed = 1e-3;     // slower slip has proportionally less friction, m/s
  int friction_rounds = 10;      // most solutions of a step with revised normal forces
};

}  // namespace retiarius
