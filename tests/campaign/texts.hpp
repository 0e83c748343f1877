// Campaign and mission texts that the tests share.
#pragma once

#include <string>

namespace retiarius::testing {

// A campaign of one uniform variable x, 100 random runs; `more` is added at the end.
inline std::string least_campaign(const std::string& more = "") {
  return R"(mission = "m.toml"
[plan]
design = "monte-carlo"
runs = 100
[[variable]]
name = "x"
set = "target.position[0]"
distribution = "uniform"
low = -1.0
high = 1.0
)" + more;
}

// A plan and the table of one variable for each of the texts.
inline std::string campaign_text(const std::string& plan, const std::string& variables) {
  return "mission = \"m.toml\"\n[plan]\n" + plan + "\n" + variables;
}

inline std::string uniform_variable(const std::string& name) {
  return "[[variable]]\nname = \"" + name + "\"\nset = \"net." + name +
         "\"\ndistribution = \"uniform\"\nlow = 0.0\nhigh = 1.0\n";
}

}  // namespace retiarius::testing
