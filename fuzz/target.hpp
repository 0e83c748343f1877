// A fuzz target: one function that takes any bytes and may only return or refuse them. libFuzzer
// calls it millions of times; the program replay calls it with the files of the corpora.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include "retiarius/base/error.hpp"

namespace retiarius::fuzz {

// Calls `read`. Input may be refused by an InputError with a text; any other exception escapes,
// which is a finding.
template <class Read>
void accept_or_refuse(Read&& read) {
  try {
    read();
  } catch (const InputError& error) {
    if (std::string_view(error.what()).empty()) throw std::logic_error("refused without a word");
  }
}

// A property that holds whatever the input is.
inline void require(bool holds, const char* what) {
  if (!holds) throw std::logic_error(what);
}

}  // namespace retiarius::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

// Defines the target: the body sees `bytes`, a std::string_view.
#define RETIARIUS_FUZZ_TARGET(bytes)                                                     \
  static void run_target(std::string_view bytes);                                        \
  extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {    \
    run_target(std::string_view(size ? reinterpret_cast<const char*>(data) : "", size)); \
    return 0;                                                                            \
  }                                                                                      \
  static void run_target(std::string_view bytes)
