// What `retiarius check-contact` does: looks for threads that went into or through something.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "retiarius/base/vec.hpp"

namespace retiarius {

enum class ContactFault {
  penetration,  // at a recorded state, nearer than the radii
  approach,     // between two recorded states, nearer than the stated share of the radii
  crossing,     // between two recorded states, a centre line met the surface or the other's line
};
const char* to_string(ContactFault fault);

// The worst of its kind for a thread and what it touches.
struct ContactViolation {
  ContactFault fault = ContactFault::penetration;
  double time = 0.0;  // s
  Index segment = kNone;
  Index body = kNone;     // what it met: a body,
  Index other = kNone;    // or another segment
  double distance = 0.0;  // m, centre line to surface (negative inside) or to the other's
  double depth = 0.0;     // m, by which the radii overlap
};

struct ContactCheckOptions {
  double share = 0.5;        // of the radii that must stay free between states
  double slack = 1e-6;       // of the radii that may be missing at a state: rounding
  std::optional<bool> self;  // thread on thread; default: what the mission's contact.self says
};

struct ContactCheck {
  std::size_t states = 0, motions = 0;  // recorded states, and motions between them
  bool self = false;                    // thread on thread was checked in some phase
  std::uint64_t looked_at = 0;          // states and motions of pairs that were not far apart
  std::uint64_t unresolved = 0;         // motions too long for the resolution: count as violations
  // Every pair and kind of violation counts once for each state or motion.
  std::uint64_t penetrations = 0, approaches = 0, crossings = 0;
  double deepest = 0.0;                 // m
  std::vector<ContactViolation> worst;  // by kind and what was met, the deepest each
  std::vector<std::string> bodies;      // their names

  bool clean() const { return penetrations + approaches + crossings + unresolved == 0; }
};

// Checks every recorded state of DIR/run.h5, and the motion between each two in a row: nodes
// straight, bodies by the constant twist that leads from pose to pose the shorter way round.
// Threads against bodies (their true shapes; a mesh as recorded), and with `self` threads against
// threads, where neighbours within three times the sum of radii along the net are left out. By
// search in plain loops, with nothing taken from contact detection. To see the motion within steps
// the run must have recorded every one (output.every_step). Throws InputError when the run cannot
// be read.
ContactCheck check_contact(const std::filesystem::path& folder,
                           const ContactCheckOptions& options = {});

}  // namespace retiarius
