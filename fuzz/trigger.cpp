// Any text as the condition that ends a phase.
#include "retiarius/mission/trigger.hpp"

#include "fuzz/target.hpp"

RETIARIUS_FUZZ_TARGET(bytes) {
  using namespace retiarius;
  fuzz::accept_or_refuse([&] {
    const Trigger trigger = Trigger::parse(std::string(bytes));
    trigger.evaluate({.time = 1.0, .phase_time = 0.5, .mouth_area = 2.0});
    trigger.latest_time(0.5);
    fuzz::require(Trigger::parse(trigger.text()).text() == trigger.text(),
                  "the trigger's text is another trigger");
  });
}
