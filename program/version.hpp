// What `retiarius --version` prints.
#pragma once

#include <string>

namespace retiarius::program {

std::string version_text();

}  // namespace retiarius::program
