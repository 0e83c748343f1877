// retiarius report DIR: makes report.html again; with several folders, a page that compares them.
#include <memory>

#include <fmt/format.h>

#include "program/commands.hpp"
#include "program/console.hpp"
#include "retiarius/base/error.hpp"
#include "retiarius/record/file.hpp"
#include "retiarius/report/report_page.hpp"

namespace retiarius::program {

namespace {

namespace fs = std::filesystem;

struct ReportArguments {
  std::vector<std::string> runs;
  std::string out;
};

void report(const ReportArguments& arguments) {
  const std::vector<fs::path> runs(arguments.runs.begin(), arguments.runs.end());
  for (const fs::path& run : runs)
    if (!fs::is_directory(run))
      throw InputError(
          fmt::format("there is no folder {}; pass the folder of a run", run.string()));
  const bool several = runs.size() > 1;
  const fs::path usual = several ? fs::path("comparison.html") : runs[0] / "report.html";
  const fs::path out = arguments.out.empty() ? usual : fs::path(arguments.out);
  write_atomically(out, several ? comparison_page(runs) : report_page(runs[0]));
  print(fmt::format("{} written\n", out.string()));
}

}  // namespace

void add_report_command(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("report", "Make a run's report again, or compare several runs");
  auto arguments = std::make_shared<ReportArguments>();
  command->add_option("DIR", arguments->runs, "Folder of a run; several are compared")
      ->required()
      ->type_name("");
  command
      ->add_option("--out", arguments->out,
                   "Page to write; default DIR/report.html, of several runs comparison.html")
      ->type_name("FILE");
  command->callback([arguments] { report(*arguments); });
}

}  // namespace retiarius::program
