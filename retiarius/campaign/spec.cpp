#include "retiarius/campaign/spec.hpp"

#include <filesystem>

namespace retiarius {

int VariableSpec::dimensions() const {
  if (distribution == Distribution::uniform_attitude) return 3;
  return distribution == Distribution::cone ? 2 : 1;
}

std::string CampaignSpec::mission_path() const {
  return (std::filesystem::path(folder) / mission).lexically_normal().string();
}

std::vector<std::string> CampaignSpec::input_names() const {
  std::vector<std::string> names;
  for (const VariableSpec& variable : variables) {
    switch (variable.dimensions()) {
      case 3:
        for (const char* angle : {".yaw", ".pitch", ".roll"})
          names.push_back(variable.name + angle);
        break;
      case 2:
        for (const char* angle : {".angle", ".azimuth"}) names.push_back(variable.name + angle);
        break;
      default:
        names.push_back(variable.name);
    }
  }
  return names;
}

}  // namespace retiarius
