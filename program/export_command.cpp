// retiarius export DIR: a run's data in other forms.
#include <memory>

#include <fmt/format.h>

#include "program/arguments.hpp"
#include "program/commands.hpp"
#include "program/console.hpp"
#include "program/output_guard.hpp"
#include "retiarius/record/export_run.hpp"

namespace retiarius::program {

namespace {

struct ExportArguments {
  std::string run, form, out;
};

void export_scene(const ExportArguments& arguments) {
  const std::filesystem::path run = arguments.run;
  const std::filesystem::path out =
      arguments.out.empty() ? run / "run.glb" : std::filesystem::path(arguments.out);
  const GlbReport report = export_glb(run, out);
  print(fmt::format("{} written", out.string()));
  if (report.written < report.recorded)
    print(fmt::format(" with {} of {} frames", report.written, report.recorded));
  print("\n");
}

void export_run(const ExportArguments& arguments) {
  if (arguments.form == "glb") return export_scene(arguments);
  const std::filesystem::path run = arguments.run;
  const std::filesystem::path out =
      arguments.out.empty() ? run / arguments.form : std::filesystem::path(arguments.out);
  OutputGuard guard(out);
  if (arguments.form == "vtk") {
    export_vtk(run, out);
  } else {
    export_csv(run, out);
  }
  guard.keep();
  print(fmt::format("{} written\n", out.string()));
}

}  // namespace

void add_export_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("export", "Write a run's data in another form");
  auto arguments = std::make_shared<ExportArguments>();
  command->add_option("DIR", arguments->run, "Folder of a run")->required()->type_name("");
  command
      ->add_option("--to", arguments->form,
                   "Form: vtk (for ParaView), csv, or glb (for Blender and 3D viewers)")
      ->required()
      ->type_name("vtk|csv|glb")
      ->check(quiet(CLI::IsMember({"vtk", "csv", "glb"})));
  command
      ->add_option("--out", arguments->out,
                   "Folder to write; default DIR/vtk or DIR/csv; of glb the file, default "
                   "DIR/run.glb")
      ->type_name("DIR2");
  command->callback([arguments] { export_run(*arguments); });
}

}  // namespace retiarius::program
