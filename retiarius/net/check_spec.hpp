// Range checks of a NetSpec, for users of the library and of the mission file alike.
#pragma once

#include <cstdint>

#include "retiarius/net/spec.hpp"

namespace retiarius {

// Checks every number of the spec. Throws InputError "net.KEY = VALUE: what is allowed".
void check_spec(const NetSpec& spec);

// n = side / mesh, the number of pieces along one side of the outline. Throws InputError that names
// the nearest mesh sizes if the mesh does not divide the side to 1e-9 relative.
std::int64_t pieces_per_side(const NetSpec& spec);

}  // namespace retiarius
