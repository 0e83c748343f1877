// The result of a contact check as JSON.
#pragma once

#include <string>

#include "retiarius/check/check_contact.hpp"

namespace retiarius {

// One object: format, clean, states, motions, looked_at, unresolved, self, penetrations,
// approaches, crossings, deepest (m) and worst (fault, time, segment, body or other, distance,
// depth).
std::string contact_check_json(const ContactCheck& check);

}  // namespace retiarius
