// retiarius view DIR: shows a run, finished or going on, in the browser.
#include <chrono>
#include <memory>
#include <thread>

#include <fmt/format.h>

#include "program/commands.hpp"
#include "program/console.hpp"
#include "program/interruption.hpp"
#include "program/live_server.hpp"
#include "retiarius/base/error.hpp"
#include "retiarius/report/read_report.hpp"

namespace retiarius::program {

namespace {

namespace fs = std::filesystem;

struct ViewArguments {
  std::string run;
  ServerArguments server;
};

std::string title_of(const fs::path& run) {
  const bool begun = fs::exists(run / "summary.json") || fs::exists(run / "replay.bin");
  if (begun) return read_outcome(run).title;
  tell_warning(fmt::format("there is no recording in {} yet; the page waits for it", run.string()));
  return fs::absolute(run).lexically_normal().filename().string();
}

void view(const ViewArguments& arguments) {
  const fs::path run = arguments.run;
  if (!fs::is_directory(run))
    throw InputError(fmt::format("there is no folder {}; pass the folder of a run", run.string()));
  const LiveServer server(run, title_of(run), arguments.server);
  const std::atomic<bool>& stop = catch_interruptions();
  print(fmt::format("{}  (Ctrl-C ends it)\n", server.address()));
  flush_output();
  while (!stop) std::this_thread::sleep_for(std::chrono::milliseconds(50));
}

}  // namespace

void add_view_command(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("view", "Show a run in the browser, also while it goes on");
  auto arguments = std::make_shared<ViewArguments>();
  command->add_option("DIR", arguments->run, "Folder of a run")->required()->type_name("");
  arguments->server.add_to(*command);
  command->callback([arguments] { view(*arguments); });
}

}  // namespace retiarius::program
