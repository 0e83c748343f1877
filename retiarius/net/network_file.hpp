// Import of a network from a plain text file.
#pragma once

#include <string>

#include "retiarius/net/layout.hpp"

namespace retiarius {

// Reads a network file: one statement a line, words separated by blanks, # starts a comment.
//
//   node X Y Z [MASS]                    position (m), added mass (kg, default 0); numbered from 0
//   segment A B [REST_LENGTH] [border]   joins two nodes; rest length (m, default their distance);
//                                        `border`: made of the border's material
//   thread N0 N1 N2 ...                  a thread through nodes that segments join in pairs; a
//                                        closed thread repeats its first node at the end
//   corner N                             the mouth's corners, counter-clockwise seen from +z
//
// Statements may stand in any order. The net lies in the xy-plane and its centre is the file's
// origin. A segment that no thread passes is a thread of its own and so has no joints at its ends.
// `net.segments` divides each segment of the file. Segments are numbered thread by thread in the
// file's order, those without thread last. Without `corner` lines the corners are those of the
// convex hull of the nodes, counter-clockwise from +x about their mean, and none if all nodes lie
// on one line. The perimeter is the closed loop of the `border` segments, else the boundary of the
// outer face of the net seen from +z; it is empty where that is no simple loop through corner 0.
//
// Throws InputError with file, line and column for a wrong statement, and without these for a file
// that cannot be read or holds no segment.
Layout read_network_file(const std::string& path);

// The same for the content of a file; `path` is only named in errors.
Layout parse_network(const std::string& content, const std::string& path);

}  // namespace retiarius
