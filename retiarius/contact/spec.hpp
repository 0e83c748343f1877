// What a mission says about contact ([contact]): plain data.
#pragma once

namespace retiarius {

enum class ContactMethod { none, modified_mass };

struct ContactSpec {
  ContactMethod method = ContactMethod::none;
  double friction = 0.0;  // Coulomb coefficient, thread on body
};

}  // namespace retiarius
