// Any text as one --set on a mission that has every table.
#include "fuzz/target.hpp"
#include "retiarius/mission/reader.hpp"
#include "retiarius/mission/writer.hpp"

RETIARIUS_FUZZ_TARGET(bytes) {
  using namespace retiarius;
  static const std::string text = starter_mission("a");
  fuzz::accept_or_refuse(
      [&] { parse_mission(text, "m.toml", "/nonexistent", {std::string(bytes)}); });
}
