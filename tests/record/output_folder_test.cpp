#include "retiarius/record/output_folder.hpp"

#include <gmock/gmock.h>

#include "retiarius/base/error.hpp"
#include "retiarius/record/file.hpp"
#include "tests/record/sample_run.hpp"

namespace retiarius {
namespace {

using testing::error_text;
using ::testing::HasSubstr;
using testing::TemporaryFolder;

TEST(OutputFolder, IsCreatedWithItsParentsAndLeftEmpty) {
  TemporaryFolder base;
  prepare_output_folder(base / "a/b");
  EXPECT_TRUE(std::filesystem::is_empty(base / "a/b"));
  EXPECT_NO_THROW(prepare_output_folder(base / "a/b"));
}

TEST(OutputFolder, RefusesAFolderThatIsNotEmpty) {
  TemporaryFolder base;
  write_atomically(base / "history.csv", "precious");
  EXPECT_EQ(error_text<InputError>([&] { prepare_output_folder(base.path()); }),
            "the output folder " + base.path().string() +
                " exists and is not empty; pass another --out or remove it");
  EXPECT_EQ(read_whole_file(base / "history.csv"), "precious");
}

TEST(OutputFolder, OverwritingRemovesOnlyWhatARunLeaves) {
  TemporaryFolder base;
  write_atomically(base / "history.csv", "old");
  write_atomically(base / "notes.txt", "mine");
  std::filesystem::create_directory(base / "frames");
  write_atomically(base / "frames/frame_000000.vtp", "old");
  prepare_output_folder(base.path(), true);
  EXPECT_FALSE(std::filesystem::exists(base / "history.csv"));
  EXPECT_FALSE(std::filesystem::exists(base / "frames"));
  EXPECT_EQ(read_whole_file(base / "notes.txt"), "mine");
}

TEST(OutputFolder, SaysWhyAPlaceCannotBeUsed) {
  TemporaryFolder base;
  write_atomically(base / "file", "x");
  EXPECT_THAT(error_text<InputError>([&] { prepare_output_folder(base / "file"); }),
              HasSubstr("it is not a folder; pass another --out"));
  EXPECT_THAT(error_text<InputError>([&] { prepare_output_folder(base / "file/below"); }),
              HasSubstr("pass another --out"));
  EXPECT_THAT(error_text<InputError>([] { prepare_output_folder("/proc/retiarius"); }),
              HasSubstr("cannot write results to /proc/retiarius"));
  EXPECT_THAT(error_text<InputError>([] { prepare_output_folder(""); }), HasSubstr("empty name"));
}

}  // namespace
}  // namespace retiarius
