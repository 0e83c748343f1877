// Counts of a layout, and the limit that node indices set.
#pragma once

#include "retiarius/net/layout.hpp"
#include "retiarius/net/network.hpp"

namespace retiarius {

// What a build of this layout gives.
NetworkCounts count_layout(const Layout& layout, const NetSpec& spec);

// Throws InputError if there are more nodes, segments or joints than an Index can number.
void check_counts(const NetworkCounts& counts, const NetSpec& spec);

}  // namespace retiarius
