// The files that a mission names lie relative to its folder.
#pragma once

#include <filesystem>

#include "retiarius/mission/mission.hpp"

namespace retiarius {

// The mission's net with the path of its network file as any working folder can use it.
inline NetSpec located_net(const Mission& mission) {
  NetSpec net = mission.net;
  if (!net.file.empty()) net.file = (std::filesystem::path(mission.folder) / net.file).string();
  return net;
}

}  // namespace retiarius
