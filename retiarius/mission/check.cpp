#include "retiarius/mission/check.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include "retiarius/mission/key.hpp"

namespace retiarius {

namespace {

[[noreturn]] void fail(const Places& places, const std::string& path, const std::string& why) {
  throw InputError(places.of(path), fmt::format("{} {}", path, why));
}

void check_exists(const Mission& mission, const Places& places, const std::string& path,
                  const std::string& file) {
  if (file.empty()) return;
  std::error_code error;
  const auto full = std::filesystem::path(mission.folder) / file;
  if (!std::filesystem::exists(full, error)) {
    fail(places, path, fmt::format("= {}: there is no {}", quoted(file), full.string()));
  }
}

// A single [target] has no index in the file.
std::string target_path(const Places& places, std::size_t i) {
  const std::string indexed = fmt::format("target[{}]", i);
  return places.has(indexed) ? indexed : "target";
}

void check_plane(const BodySpec& body, const Places& places, const std::string& path) {
  if (body.shape == ShapeKind::plane && body.motion == BodyMotion::free) {
    fail(places, path + ".motion", "= \"free\": a plane must be fixed, write motion = \"fixed\"");
  }
}

void check_mass(const BodySpec& body, const Places& places, const std::string& path) {
  if (body.mass && body.density) {
    fail(places, path + ".density", "and mass are both given; give one of them");
  }
  if (body.motion == BodyMotion::free && !body.mass && !body.density) {
    fail(places, path, "is free and needs mass or density, or write motion = \"fixed\"");
  }
  if (!body.inertia) return;
  const auto& [a, b, c] = *body.inertia;
  if (a + b < c || b + c < a || c + a < b) {
    fail(places, path + ".inertia",
         fmt::format("= [{}, {}, {}]: no solid has these moments; each is at most the sum of the "
                     "other two",
                     a, b, c));
  }
}

void check_at_rest(const BodySpec& body, const Places& places, const std::string& path) {
  if (body.motion == BodyMotion::free) return;
  if (!body.velocity.isZero(0.0)) fail(places, path + ".velocity", "must be zero: it is fixed");
  if (!body.spin_deg.isZero(0.0)) fail(places, path + ".spin_deg", "must be zero: it is fixed");
}

}  // namespace

int corner_count(const NetSpec& net) {
  switch (net.pattern) {
    case Pattern::hexagon:
      return 6;
    case Pattern::square:
      return 4;
    case Pattern::triangle:
      return 3;
    case Pattern::polygon:
      return net.sides;
    case Pattern::file:
      return 0;
  }
  return 0;
}

bool is_multiple(double whole, double part) {
  const double times = whole / part;
  return times > 0.5 && std::abs(times - std::round(times)) <= 1e-9 * times;
}

void check_net(const Mission& mission, const Places& places) {
  const NetSpec& net = mission.net;
  if (net.pattern == Pattern::triangle && net.cell == Cell::square) {
    fail(places, "net.cell",
         "= \"square\" belongs to pattern square; triangle has natural, diamond");
  }
  if (net.mesh > net.side) {
    fail(places, "net.mesh",
         fmt::format("= {} m is larger than net.side = {} m", net.mesh, net.side));
  }
  if (net.zigzag && net.scale > 1.0) {
    fail(places, "net.zigzag", fmt::format("needs net.scale of at most 1, not {}", net.scale));
  }
  if (!net.state.empty() && (net.zigzag || net.scale != 1.0)) {
    fail(places, "net.state", "gives the initial positions; leave out net.scale and net.zigzag");
  }
  check_exists(mission, places, "net.file", net.file);
  check_exists(mission, places, "net.state", net.state);
}

void check_targets(const Mission& mission, const Places& places) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < mission.targets.size(); ++i) {
    const BodySpec& body = mission.targets[i];
    const std::string path = target_path(places, i);
    check_plane(body, places, path);
    check_mass(body, places, path);
    check_at_rest(body, places, path);
    check_exists(mission, places, path + ".file", body.file);
    if (!names.insert(body.name).second) {
      fail(places, path + ".name",
           fmt::format("= {} is taken by another target", quoted(body.name)));
    }
  }
}

// The explicit integrator's sub-steps follow the stable step and nothing else.
void check_integrators(const Mission& mission, const Places& places) {
  for (std::size_t i = 0; i < mission.phases.size(); ++i) {
    const IntegratorSpec& integrator = mission.phases[i].integrator;
    if (!integrator.adaptive || integrator.method != Method::explicit_differences) continue;
    const std::string own = fmt::format("phase[{}].integrator.adaptive", i);
    fail(places, places.has(own) ? own : "integrator.adaptive",
         "= true: explicit steps are not adaptive; leave it out or take another "
         "integrator.method");
  }
}

void check_contact(const Mission& mission, const Places& places) {
  for (std::size_t i = 0; i < mission.phases.size(); ++i) {
    const ContactSpec& contact = mission.phases[i].contact;
    const auto place = [&](const char* key) {
      const std::string own = fmt::format("phase[{}].contact.{}", i, key);
      return places.has(own) ? own : fmt::format("contact.{}", key);
    };
    if (contact.self && contact.method != ContactMethod::barrier)
      fail(places, place("self"),
           "= true: threads touch each other only with contact.method = \"barrier\"");
    for (std::size_t t = 0; t < mission.targets.size(); ++t) {
      if (!mission.targets[t].friction || contact.method != ContactMethod::modified_mass) continue;
      fail(places, target_path(places, t) + ".friction",
           "is heeded by barriers only; use contact.friction, or contact.method = \"barrier\"");
    }
    if (contact.method == ContactMethod::barrier &&
        mission.phases[i].integrator.method == Method::explicit_differences)
      fail(places, place("method"),
           "= \"barrier\": the explicit integrator has contact by modified mass only");
  }
}

void check_output(const Mission& mission, const Places& places) {
  const OutputSpec& output = mission.output;
  if (!is_multiple(output.frame_interval, output.interval)) {
    fail(places, "output.frame_interval",
         fmt::format("= {} s is not a multiple of output.interval = {} s", output.frame_interval,
                     output.interval));
  }
  for (std::size_t i = 0; i < mission.phases.size(); ++i) {
    const IntegratorSpec& integrator = mission.phases[i].integrator;
    if (integrator.method == Method::static_solve || integrator.adaptive) continue;
    if (is_multiple(output.interval, integrator.step)) continue;
    const std::string own = fmt::format("phase[{}].integrator.step", i);
    const std::string path = places.has(own) ? own : "integrator.step";
    const std::string at = places.has(path) ? path : "output.interval";
    throw InputError(places.of(at),
                     fmt::format("{} = {} s does not divide output.interval = {} s; change one so "
                                 "that rows fall on steps",
                                 path, integrator.step, output.interval));
  }
  std::set<std::string> names;
  for (std::size_t i = 0; i < mission.probes.size(); ++i) {
    const std::string& name = mission.probes[i].name;
    const std::string path = fmt::format("probe[{}].name", i);
    const bool plain = !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) {
      return c < 128 && (std::isalnum(c) || c == '_' || c == '-');
    });
    if (!plain) {
      fail(places, path, fmt::format("= {}: use letters, digits, _ and -", quoted(name)));
    }
    if (!names.insert(name).second) {
      fail(places, path, fmt::format("= {} is taken by another probe", quoted(name)));
    }
  }
}

void check_mission(const Mission& mission, const Places& places) {
  check_net(mission, places);
  check_targets(mission, places);
  check_phases(mission, places);
  check_integrators(mission, places);
  check_contact(mission, places);
  check_output(mission, places);
}

}  // namespace retiarius
