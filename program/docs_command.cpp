// retiarius docs mission-file, campaign-file: the pages that document these files, from their
// schemas.
#include <memory>

#include "program/arguments.hpp"
#include "program/commands.hpp"
#include "program/console.hpp"
#include "retiarius/campaign/schema.hpp"
#include "retiarius/mission/writer.hpp"

namespace retiarius::program {

void add_docs_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("docs", "Print generated documentation");
  command->group("");  // not in the help: it is for those who maintain docs/
  auto page = std::make_shared<std::string>();
  command->add_option("PAGE", *page, "mission-file or campaign-file")
      ->required()
      ->type_name("")
      ->check(quiet(CLI::IsMember({"mission-file", "campaign-file"})));
  // The option refers to `page`, which must live as long.
  command->callback([page] {
    print(*page == "mission-file" ? mission_file_markdown() : campaign_file_markdown());
  });
}

}  // namespace retiarius::program
