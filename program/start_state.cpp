#include "program/start_state.hpp"

#include <filesystem>

#include "retiarius/record/checkpoint.hpp"

namespace retiarius::program {

std::optional<State> net_state(const Mission& mission) {
  if (mission.net.state.empty()) return std::nullopt;
  return read_checkpoint(std::filesystem::path(mission.folder) / mission.net.state);
}

}  // namespace retiarius::program
