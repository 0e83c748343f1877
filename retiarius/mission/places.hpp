// Where in the mission file each key and table was found, for messages of later checks.
#pragma once

#include <map>
#include <string>

#include "retiarius/base/error.hpp"

namespace retiarius {

class Places {
 public:
  explicit Places(std::string file) : file_(std::move(file)) {}

  void set(const std::string& path, const SourcePlace& place) { places_[path] = place; }

  // The place of "phase[1].integrator.step"; where it was not written, that of the table it would
  // stand in; at last the file alone.
  SourcePlace of(const std::string& path) const;

  // Whether the file or an override gives this key.
  bool has(const std::string& path) const { return places_.count(path) > 0; }

 private:
  std::string file_;
  std::map<std::string, SourcePlace> places_;
};

}  // namespace retiarius
