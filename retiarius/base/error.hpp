// The exceptions of the library. The library never exits and never prints; the program maps these
// to exit codes.
#pragma once

#include <stdexcept>
#include <string>

namespace retiarius {

// Base of all; the message names the object, the value and the remedy.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Where in a text file something was found; line and column count from 1, 0 where unknown.
struct SourcePlace {
  std::string file;
  int line = 0;
  int column = 0;
};

// Something the user gave is wrong: file, key, value. Exit code 2.
class InputError : public Error {
 public:
  explicit InputError(const std::string& message) : Error(message) {}
  InputError(const SourcePlace& place, const std::string& message)
      : Error(prefix(place) + message), place_(place) {}

  const SourcePlace& place() const { return place_; }

 private:
  static std::string prefix(const SourcePlace& place);
  SourcePlace place_;
};

// A run could not go on: a step that does not converge, a full disk. Exit code 1.
class RunError : public Error {
 public:
  using Error::Error;
};

}  // namespace retiarius
