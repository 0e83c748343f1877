#include "retiarius/check/check_json.hpp"

#include <nlohmann/json.hpp>

namespace retiarius {

std::string contact_check_json(const ContactCheck& check) {
  using Json = nlohmann::ordered_json;
  Json worst = Json::array();
  for (const ContactViolation& v : check.worst) {
    Json entry{{"fault", to_string(v.fault)}, {"time", v.time}, {"segment", v.segment}};
    if (v.body != kNone) entry["body"] = check.bodies[static_cast<std::size_t>(v.body)];
    if (v.other != kNone) entry["other"] = v.other;
    entry["distance"] = v.distance;
    entry["depth"] = v.depth;
    worst.push_back(std::move(entry));
  }
  const Json document{{"format", 1},
                      {"clean", check.clean()},
                      {"states", check.states},
                      {"motions", check.motions},
                      {"looked_at", check.looked_at},
                      {"unresolved", check.unresolved},
                      {"self", check.self},
                      {"penetrations", check.penetrations},
                      {"approaches", check.approaches},
                      {"crossings", check.crossings},
                      {"deepest", check.deepest},
                      {"worst", std::move(worst)}};
  return document.dump(2) + "\n";
}

}  // namespace retiarius
