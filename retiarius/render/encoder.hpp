// Films through ffmpeg, another program: pictures go into its standard input.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <sys/types.h>

namespace retiarius::render {

// Throws InputError that names the Debian package where there is no program ffmpeg in PATH.
void require_ffmpeg();

// A running program that reads what is written to it. Throws RunError with the program's own last
// words where it fails.
class Encoder {
 public:
  explicit Encoder(const std::vector<std::string>& command);
  ~Encoder();  // ends the program where it was not finished
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;

  void write(std::string_view bytes);
  void finish();  // closes its input and waits for its end

 private:
  [[noreturn]] void fail();
  int wait();

  std::string name_;
  pid_t id_ = -1;
  int input_ = -1, messages_ = -1;
};

}  // namespace retiarius::render
