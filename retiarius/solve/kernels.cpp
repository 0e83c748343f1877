#include "retiarius/solve/kernels.hpp"

#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "retiarius/base/error.hpp"
#include "retiarius/solve/kernel_table.hpp"

namespace retiarius {

namespace kernels {
namespace portable {
extern const KernelTable table;
}
#ifdef RETIARIUS_X86_KERNELS
namespace avx2 {
extern const KernelTable table;
}
namespace avx512 {
extern const KernelTable table;
}
#endif
}  // namespace kernels

namespace {

struct Choice {
  std::string_view name;
  const kernels::KernelTable* table;
};

std::vector<Choice> choices() {
  std::vector<Choice> found{{"portable", &kernels::portable::table}};
#ifdef RETIARIUS_X86_KERNELS
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
    found.push_back({"avx2", &kernels::avx2::table});
  }
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("fma")) {
    found.push_back({"avx512", &kernels::avx512::table});
  }
#endif
  return found;
}

Choice& chosen() {
  static Choice choice = choices().back();
  return choice;
}

}  // namespace

const kernels::KernelTable& kernels::active() { return *chosen().table; }

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
