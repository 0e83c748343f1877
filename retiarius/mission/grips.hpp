// Where a net is gripped for folding.
#pragma once

#include <vector>

#include "retiarius/mission/mission.hpp"
#include "retiarius/net/network.hpp"

namespace retiarius {

// The knots nearest to chosen points of the flat net, about `grip_spacing` apart, and all bullets:
//   "lattice"  in each sector between the centre and two corners, a lattice parallel to the two
//              spokes (fold lines parallel to the spokes)
//   "spokes"   on spokes and sides alone (Huang et al. 2022)
//   names      as select_nodes() knows them
// Ascending, each once. Throws InputError where the net has no corners to span a lattice.
std::vector<Index> choose_grips(const PhaseSpec& phase, const Network& network);

}  // namespace retiarius
