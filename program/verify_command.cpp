// retiarius verify: the verification cases, told as a table and written as JSON and a page.
#include <chrono>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "program/arguments.hpp"
#include "program/commands.hpp"
#include "program/console.hpp"
#include "program/verification_results.hpp"
#include "retiarius/base/parallel.hpp"
#include "verification/framework/ladder.hpp"
#include "verification/framework/results_text.hpp"

namespace retiarius::program {

namespace {

using namespace verification;

struct VerifyArguments {
  std::vector<std::string> cases;
  std::string out = "out/verification";
  ComputingArguments computing;
  bool list = false, quick = false;
};

ExitCode verify(const VerifyArguments& arguments) {
  const std::vector<const Case*> cases = chosen_cases(arguments.cases);
  if (arguments.list) {
    print(list_text(cases));
    return kOk;
  }
  arguments.computing.apply();
  // The cases are small and many: each has one thread of its own.
  const int workers = threads();
  set_threads(1);
  const auto start = std::chrono::steady_clock::now();
  const std::vector<Rung> rungs =
      climb(cases, arguments.quick, workers, [](const Rung& rung) { print(case_text(rung)); });
  print(verdict_text(rungs));
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  const ExitCode code = conclude(rungs, arguments.out, arguments.quick, wall.count());
  print(fmt::format("\nreport: {}\n",
                    (std::filesystem::path(arguments.out) / "verification.html").string()));
  return code;
}

}  // namespace

void add_verify_command(CLI::App& app, ExitCode& code) {
  CLI::App* command =
      app.add_subcommand("verify", "Compare with exact, published and independent results");
  auto arguments = std::make_shared<VerifyArguments>();
  command->add_option("CASE", arguments->cases, "Cases to run; default all")->type_name("");
  command->add_option("--out", arguments->out, "Folder for the results; default out/verification")
      ->type_name("DIR");
  command->add_flag("--list", arguments->list, "List the cases and end");
  command->add_flag("--quick", arguments->quick, "The quick form: minutes become seconds");
  arguments->computing.add_to(*command);
  command->footer("Exit codes: 0 all within bounds; 1 a case missed its bound; 2 wrong usage.");
  command->callback([arguments, &code] { code = verify(*arguments); });
}

}  // namespace retiarius::program
