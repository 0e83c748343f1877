// Everything that one run leaves behind, the report included.
#pragma once

#include <filesystem>
#include <memory>

#include "retiarius/record/recorders.hpp"

namespace retiarius {

// make_recorders() with the observer that writes report.html. Throws as that does.
std::unique_ptr<FanOut> make_run_recorders(const std::filesystem::path& folder,
                                           const RecordOptions& options);

}  // namespace retiarius
