#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "retiarius/mission/check.hpp"
#include "retiarius/mission/key.hpp"

namespace retiarius {

namespace {

class PhaseCheck {
 public:
  PhaseCheck(const Mission& mission, const Places& places, std::size_t i)
      : mission_(mission),
        phase_(mission.phases[i]),
        places_(places),
        path_(fmt::format("phase[{}]", i)) {}

  void check() const {
    if (std::find(phase_.fix.begin(), phase_.fix.end(), "none") != phase_.fix.end()) {
      fail("fix", "mixes none with names of nodes");
    }
    if (phase_.kind == PhaseKind::shoot) check_shot();
    if (phase_.kind == PhaseKind::fold) check_fold();
    if (phase_.kind == PhaseKind::close && mission_.targets.empty()) {
      fail("kind", "= \"close\" needs a [target] to close around");
    }
    for (std::size_t i = 0; i < phase_.move.size(); ++i) check_move(i);
  }

  [[noreturn]] void fail(const std::string& key, const std::string& why) const {
    const std::string path = path_ + "." + key;
    throw InputError(places_.of(path), fmt::format("{} {}", path, why));
  }

 private:
  void check_shot() const {
    check_corners("speed", phase_.speed);
    check_corners("half_angle_deg", phase_.half_angle_deg);
    check_corners("delay", phase_.delay);
    if (phase_.axis.isZero(0.0)) fail("axis", "= [0, 0, 0] is no direction");
  }

  void check_corners(const std::string& key, const std::vector<double>& list) const {
    const int corners = corner_count(mission_.net);
    if (list.size() == 1 || corners == 0) return;
    if (list.size() == static_cast<std::size_t>(corners)) return;
    fail(key, fmt::format("lists {} values, but the net has {} corners: give one value or {}",
                          list.size(), corners, corners));
  }

  void check_fold() const {
    const auto& grips = phase_.grips;
    for (const std::string pattern : {"lattice", "spokes"}) {
      if (std::find(grips.begin(), grips.end(), pattern) == grips.end()) continue;
      if (grips.size() > 1) fail("grips", "mixes " + pattern + " with other grips");
      if (phase_.grip_spacing == 0.0) {
        fail("grip_spacing",
             fmt::format("is missing: grips = \"{}\" needs it, in m, above 0", pattern));
      }
    }
  }

  void check_move(std::size_t i) const {
    const MoveSpec& move = phase_.move[i];
    const std::string key = fmt::format("move[{}]", i);
    const bool displaced = !move.displacement.isZero(0.0);
    const bool moving = !move.velocity.isZero(0.0);
    if (displaced && moving) fail(key + ".velocity", "and displacement are both given");
    if (!displaced && !moving) fail(key, "gives neither displacement nor velocity");
    if (displaced && !std::isfinite(move.duration)) {
      fail(key + ".duration", "is missing: a displacement needs the time it takes, in s");
    }
  }

  const Mission& mission_;
  const PhaseSpec& phase_;
  const Places& places_;
  std::string path_;
};

}  // namespace

void check_phases(const Mission& mission, const Places& places) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < mission.phases.size(); ++i) {
    const PhaseCheck phase(mission, places, i);
    phase.check();
    const std::string& name = mission.phases[i].name;
    if (!names.insert(name).second) {
      phase.fail("name", fmt::format("= {} is taken by another phase", quoted(name)));
    }
  }
}

}  // namespace retiarius
