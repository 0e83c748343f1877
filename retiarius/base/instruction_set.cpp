#include "retiarius/base/instruction_set.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "retiarius/base/error.hpp"

namespace retiarius {

namespace {

struct Choice {
  std::string_view name;
  InstructionSet set;
};

std::vector<Choice> choices() {
  std::vector<Choice> found{{"portable", InstructionSet::portable}};
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
    found.push_back({"avx2", InstructionSet::avx2});
  }
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("fma")) {
    found.push_back({"avx512", InstructionSet::avx512});
  }
#endif
  return found;
}

Choice& chosen() {
  static Choice choice = choices().back();
  return choice;
}

}  // namespace

InstructionSet instruction_set() { return chosen().set; }

std::string_view kernel_name() { return chosen().name; }

std::vector<std::string_view> available_kernels() {
  std::vector<std::string_view> names;
  for (const Choice& choice : choices()) names.push_back(choice.name);
  return names;
}

void set_kernels(std::string_view name) {
  const std::vector<Choice> found = choices();
  if (name == "auto") {
    chosen() = found.back();
    return;
  }
  for (const Choice& choice : found) {
    if (choice.name == name) {
      chosen() = choice;
      return;
    }
  }
  throw Error(fmt::format("kernels \"{}\" are not available here; choose one of: auto, {}", name,
                          fmt::join(available_kernels(), ", ")));
}

}  // namespace retiarius
