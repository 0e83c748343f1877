#include "retiarius/base/error.hpp"

namespace retiarius {

// The form "file:line:column: " that editors and terminals can jump to.
std::string InputError::prefix(const SourcePlace& place) {
  std::string text;
  if (!place.file.empty()) text += place.file + ":";
  if (place.line > 0) text += std::to_string(place.line) + ":";
  if (place.line > 0 && place.column > 0) text += std::to_string(place.column) + ":";
  return text.empty() ? text : text + " ";
}

}  // namespace retiarius
