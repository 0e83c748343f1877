#include "program/version.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "program/campaign_mpi.hpp"
#include "program/text_table.hpp"
#include "retiarius/base/build_info.hpp"
#include "retiarius/base/instruction_set.hpp"

namespace retiarius::program {

std::string version_text() {
  const BuildInfo& build = build_info();
  TextTable table;
  table.add("revision", build.revision.empty() ? "unknown" : build.revision);
  table.add("compiler", build.compiler);
  table.add("build type", build.build_type);
  for (const auto& [name, value] : build.options)
    table.add("option " + name, value.empty() ? "none" : value);
  table.add("kernels",
            fmt::format("{} (in use: {})", fmt::join(available_kernels(), ", "), kernel_name()));
  table.add("MPI", mpi_text());
  for (const auto& [name, version] : build.libraries) table.add("library " + name, version);
  std::string text = fmt::format("retiarius {}\n{}", build.version, table.text());
  text.pop_back();  // the option prints its own line end
  return text;
}

}  // namespace retiarius::program
