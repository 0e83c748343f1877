// The injected logger: the library says what happens through it and never prints by itself.
#pragma once

#include <functional>
#include <string>

namespace retiarius {

enum class LogLevel { debug, info, warning };

// Receives one line of text without line end. An empty function means silence.
using Log = std::function<void(LogLevel, const std::string&)>;

inline void log_to(const Log& log, LogLevel level, const std::string& text) {
  if (log) log(level, text);
}

}  // namespace retiarius
