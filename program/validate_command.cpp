// retiarius validate MISSION: everything that can be wrong before a run, and the resolved mission.
#include <memory>

#include "program/arguments.hpp"
#include "program/commands.hpp"
#include "program/console.hpp"
#include "program/start_state.hpp"
#include "retiarius/mission/run.hpp"
#include "retiarius/mission/writer.hpp"

namespace retiarius::program {

void add_validate_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "validate", "Check a mission without running it; print it with every default filled in");
  auto mission_arguments = std::make_shared<MissionArguments>();
  mission_arguments->add_to(*command);
  command->callback([mission_arguments] {
    const Mission mission = mission_arguments->read();
    check_memory(estimate(mission));
    const MissionModel model(mission);
    RunOptions options;
    options.net_state = net_state(mission);
    check_run(mission, model, options);
    print(to_toml(mission));
  });
}

}  // namespace retiarius::program
