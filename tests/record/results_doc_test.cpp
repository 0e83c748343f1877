// docs/results.md must list exactly what the code writes.
#include <regex>

#include <gmock/gmock.h>
#include <hdf5.h>

#include "retiarius/measure/history.hpp"
#include "retiarius/record/file.hpp"
#include "retiarius/record/run_h5.hpp"
#include "tests/record/sample_run.hpp"

namespace retiarius {
namespace {

using ::testing::HasSubstr;

std::string document() {
  return read_whole_file(std::string(RETIARIUS_SOURCE_DIR) + "/docs/results.md");
}

// The part of the document from one heading to the next.
std::string section(const std::string& heading) {
  const std::string text = document();
  const std::size_t begin = text.find("\n## " + heading);
  if (begin == std::string::npos) throw std::runtime_error("no section " + heading);
  return text.substr(begin, text.find("\n## ", begin + 1) - begin);
}

TEST(ResultsDocument, ListsTheColumnsOfTheHistoryInOrder) {
  std::string table;
  for (const HistoryColumn& column : history_columns())
    table += "| `" + column.name + "` | " + column.unit + " | " + column.meaning + " |\n";
  EXPECT_THAT(section("history.csv"), HasSubstr("|---|---|---|\n" + table + "\n"));
}

std::vector<std::string> members(hid_t file, const char* group_name) {
  std::vector<std::string> names;
  const hid_t group = H5Gopen2(file, group_name, H5P_DEFAULT);
  hsize_t position = 0;
  H5Literate(
      group, H5_INDEX_NAME, H5_ITER_INC, &position,
      [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
        static_cast<std::vector<std::string>*>(list)->push_back(name);
        return 0;
      },
      &names);
  H5Gclose(group);
  return names;
}

TEST(ResultsDocument, ListsTheDatasetsOfTheRunFile) {
  testing::TemporaryFolder folder;
  const testing::SampleRun run;
  RunH5 recorder(folder.path(), "", "");
  run.feed(recorder, 1);
  recorder.end(run.report());
  std::vector<std::string> written;
  const hid_t file = H5Fopen((folder / "run.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  ASSERT_GE(file, 0);
  for (const auto& name : members(file, "net")) written.push_back("/net/" + name);
  for (const auto& name : members(file, "frames")) written.push_back("/frames/" + name);
  for (const auto& name : members(file, "bodies/0")) written.push_back("/bodies/K/" + name);
  H5Fclose(file);

  std::vector<std::string> documented;
  const std::string text = section("run.h5");
  const std::regex row("\n\\| `(/(?:net|frames|bodies/K)/[a-z_]+)`");
  for (std::sregex_iterator it(text.begin(), text.end(), row), last; it != last; ++it)
    documented.push_back((*it)[1]);
  EXPECT_THAT(documented, ::testing::UnorderedElementsAreArray(written));
}

}  // namespace
}  // namespace retiarius
