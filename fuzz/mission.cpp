// Any text as a mission file. What reads must also be written and read again, to the same text.
#include "fuzz/target.hpp"
#include "retiarius/mission/reader.hpp"
#include "retiarius/mission/writer.hpp"

RETIARIUS_FUZZ_TARGET(bytes) {
  using namespace retiarius;
  fuzz::accept_or_refuse([&] {
    const Mission mission = parse_mission(std::string(bytes), "m.toml", "/nonexistent");
    mission_warnings(mission);
    const std::string text = to_toml(mission);
    std::string again;
    try {
      again = to_toml(parse_mission(text, "again.toml", "/nonexistent"));
    } catch (const InputError& error) {
      throw std::logic_error(std::string("what was written does not read: ") + error.what());
    }
    fuzz::require(again == text, "what was written reads as something else");
  });
}
