#include "program/command_line.hpp"

#include <cstdio>

#include <fmt/format.h>

#include "program/commands.hpp"
#include "program/console.hpp"
#include "program/failure.hpp"
#include "program/version.hpp"
#include "retiarius/mission/nearest.hpp"

namespace retiarius::program {

namespace {

constexpr const char* kDescription =
    "Simulates tether-nets that capture space debris.\n"
    "A mission is a TOML file; `retiarius new NAME` writes one to start from.";

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    if (!command->get_group().empty()) names.push_back(command->get_name());
  return names;
}

// What is wrong with the arguments, and how to learn what is right.
std::string usage_problem(const CLI::App& app, const CLI::ParseError& error, int argc,
                          char** argv) {
  const auto chosen = app.get_subcommands();
  const std::string help = fmt::format("; see `retiarius {}--help`",
                                       chosen.empty() ? "" : chosen.front()->get_name() + " ");
  if (chosen.empty() && argc < 2)
    return fmt::format("no command given{}{}", suggestion("", command_names(app)), help);
  if (chosen.empty() && argv[1][0] != '-')
    return fmt::format("there is no command {}{}{}", argv[1],
                       suggestion(argv[1], command_names(app)), help);
  return error.what() + help;
}

ExitCode parse_and_run(int argc, char** argv) {
  CLI::App app(kDescription, "retiarius");
  ExitCode code = kOk;
  app.require_subcommand(1);
  app.get_formatter()->label("REQUIRED", "");
  app.get_formatter()->label("SUBCOMMAND", "COMMAND");
  app.get_formatter()->column_width(28);
  app.set_version_flag("--version", version_text,
                       "Print version, revision, build options and kernels");
  add_run_command(app, code);
  add_resume_command(app, code);
  add_validate_command(app);
  add_new_command(app);
  add_info_command(app);
  add_export_command(app);
  add_report_command(app);
  add_render_command(app);
  add_view_command(app);
  add_campaign_command(app, code);
  add_converge_command(app, code);
  add_check_contact_command(app, code);
  add_verify_command(app, code);
  add_bench_command(app);
  add_docs_command(app);
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    if (!command->get_group().empty()) command->group("Commands");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help_or_version) {
    app.exit(help_or_version);
  } catch (const CLI::ParseError& error) {
    tell_error(usage_problem(app, error, argc, argv));
    return kBadInput;
  }
  return code;
}

}  // namespace

int run_command_line(int argc, char** argv) noexcept {
  ExitCode code = kOk;
  try {
    code = parse_and_run(argc, argv);
    flush_output();
  } catch (...) {
    code = tell_failure(std::current_exception());
  }
  return code;
}

}  // namespace retiarius::program
