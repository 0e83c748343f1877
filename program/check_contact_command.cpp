// retiarius check-contact DIR: looks for threads that went into or through something.
#include <memory>

#include <fmt/format.h>

#include "program/arguments.hpp"
#include "program/commands.hpp"
#include "program/console.hpp"
#include "program/text_table.hpp"
#include "retiarius/check/check_contact.hpp"
#include "retiarius/check/check_json.hpp"

namespace retiarius::program {

namespace {

struct CheckArguments {
  std::string run;
  ContactCheckOptions options;
  ComputingArguments computing;
  bool self = false, json = false;
};

std::string met(const ContactCheck& check, const ContactViolation& v) {
  return v.body != kNone ? check.bodies[static_cast<std::size_t>(v.body)]
                         : fmt::format("segment {}", v.other);
}

std::string worst_text(const ContactCheck& check) {
  TextTable table;
  table.add({"worst", "time", "thread", "met", "distance", "depth"});
  for (const ContactViolation& v : check.worst)
    table.add({to_string(v.fault), fmt::format("{:.6g} s", v.time),
               fmt::format("segment {}", v.segment), met(check, v), quantity(v.distance, "m"),
               quantity(v.depth, "m")});
  return "\n" + table.text();
}

std::string check_text(const ContactCheck& check) {
  TextTable table;
  table.add("states", fmt::format("{}", check.states));
  table.add("motions between them", fmt::format("{}", check.motions));
  table.add("thread on thread", check.self ? "checked" : "not checked");
  table.add("pairs looked at", fmt::format("{}", check.looked_at));
  table.add("penetrations at states", fmt::format("{}", check.penetrations));
  table.add("approaches in motion", fmt::format("{}", check.approaches));
  table.add("crossings in motion", fmt::format("{}", check.crossings));
  if (check.unresolved > 0) table.add("motions not resolved", fmt::format("{}", check.unresolved));
  return table.text() + (check.worst.empty() ? "" : worst_text(check));
}

ExitCode check_run_contact(CheckArguments& arguments) {
  arguments.computing.apply();
  if (arguments.self) arguments.options.self = true;
  const ContactCheck check = check_contact(arguments.run, arguments.options);
  print(arguments.json ? contact_check_json(check) : check_text(check));
  return check.clean() ? kOk : kFailed;
}

}  // namespace

void add_check_contact_command(CLI::App& app, ExitCode& code) {
  CLI::App* command = app.add_subcommand(
      "check-contact", "Look for threads that went into or through something in a run");
  auto arguments = std::make_shared<CheckArguments>();
  command->add_option("DIR", arguments->run, "Folder of a run")->required()->type_name("");
  command
      ->add_option("--share", arguments->options.share,
                   "Share of the radii that must stay free between states (default: 0.5)")
      ->type_name("S");
  command
      ->add_option("--slack", arguments->options.slack,
                   "Share of the radii that may be missing at a state (default: 1e-6)")
      ->type_name("S");
  command->add_flag("--self", arguments->self,
                    "Check thread on thread too (default: where contact.self is true)");
  command->add_flag("--json", arguments->json, "Print JSON");
  arguments->computing.add_to(*command);
  command->footer(
      "Looks at every recorded state and at the motion between them: record with\n"
      "output.every_step = true to have every step.\n"
      "Exit codes: 0 clean; 1 violations; 2 wrong usage or no run.");
  command->callback([arguments, &code] { code = check_run_contact(*arguments); });
}

}  // namespace retiarius::program
