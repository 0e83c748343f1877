#include "retiarius/mission/places.hpp"

namespace retiarius {

SourcePlace Places::of(const std::string& path) const {
  std::string sought = path;
  while (true) {
    const auto found = places_.find(sought);
    if (found != places_.end()) return found->second;
    const auto dot = sought.find_last_of('.');
    if (dot == std::string::npos) return {file_, 0, 0};
    sought.resize(dot);
  }
}

}  // namespace retiarius
