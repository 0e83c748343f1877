// retiarius-mujoco: the same nets in Retiarius and in MuJoCo, with differences and times.
#include <cstdio>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "retiarius/base/parallel.hpp"
#include "retiarius/record/file.hpp"
#include "verification/mujoco/mujoco_twin.hpp"
#include "verification/mujoco/outcome.hpp"

namespace {

constexpr const char* kUsage =
    "usage: retiarius-mujoco [--record FILE]\n"
    "  --record FILE  writes the comparison where docs/verification.md takes it from:\n"
    "                 verification/mujoco/results.csv\n";

int run(const std::string& record) {
  using namespace retiarius::verification;
  retiarius::set_threads(1);  // the other engine has one
  Recorded recorded;
  recorded.about.push_back(fmt::format(
      "MuJoCo {} (Debian's libmujoco): free particles joined by spring tendons; the same masses "
      "and stiffnesses in both engines, computed in the same run with one thread each.",
      mj_versionString()));
  hanging_net(recorded);
  swinging_chain(recorded);
  fmt::print("{}", outcome_text(recorded));
  const bool good = within_bounds(recorded);
  if (!record.empty() && good) retiarius::write_atomically(record, outcome_csv(recorded));
  return good ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const bool record = argc == 3 && std::strcmp(argv[1], "--record") == 0;
  if (argc != 1 && !record) {
    fmt::print(stderr, "{}", kUsage);
    return 2;
  }
  try {
    return run(record ? argv[2] : "");
  } catch (const std::exception& error) {
    fmt::print(stderr, "retiarius-mujoco: {}\n", error.what());
    return 1;
  }
}
