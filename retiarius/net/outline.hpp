// Corners and perimeter of a net whose file does not name them.
#pragma once

#include <vector>

#include "retiarius/net/layout.hpp"

namespace retiarius {

// Corners of the convex hull of the nodes in the xy-plane, counter-clockwise from +x about their
// mean; empty if all nodes lie on one line.
std::vector<Index> hull_corners(const std::vector<Vec3>& nodes);

// The perimeter's pieces, counter-clockwise from corner 0: the closed loop of the border pieces,
// else the boundary of the outer face; empty if neither is a simple loop through corner 0.
std::vector<Index> find_outline(const Layout& layout);

// Twice the area of the polygon through the nodes in the xy-plane, m2; positive counter-clockwise.
double doubled_area(const std::vector<Vec3>& nodes, const std::vector<Index>& polygon);

}  // namespace retiarius
