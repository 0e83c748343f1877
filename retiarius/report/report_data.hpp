// What a report is made from.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "retiarius/base/build_info.hpp"
#include "retiarius/mission/observer.hpp"
#include "retiarius/report/scene.hpp"

namespace retiarius {

struct ReportData {
  std::string title;
  std::uint64_t seed = 0;
  std::string start_report;
  RunReport run;
  BuildInfo build;
  std::string resolved;                   // the mission with all defaults, TOML
  std::vector<std::string> columns;       // of the history
  std::vector<std::vector<double>> rows;  // of the history, in order of time, perhaps thinned
  Scene scene;
  std::vector<Picture> pictures;  // in order of time
};

}  // namespace retiarius
