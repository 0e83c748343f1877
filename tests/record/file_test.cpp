#include "retiarius/record/file.hpp"

#include <csignal>

#include <gmock/gmock.h>
#include <sys/resource.h>

#include "retiarius/base/error.hpp"
#include "tests/record/sample_run.hpp"

namespace retiarius {
namespace {

using testing::error_text;
using ::testing::HasSubstr;
using testing::TemporaryFolder;

TEST(OutputFile, SaysWhichFileMeetsAFullDisk) {
  OutputFile file("/dev/full");
  EXPECT_EQ(error_text<RunError>([&] { file.write("x"); }),
            "cannot write /dev/full: No space left on device");
}

TEST(OutputFile, SaysWhyAFileCannotBeCreated) {
  EXPECT_EQ(error_text<RunError>([] { OutputFile file("/nowhere/a"); }),
            "cannot create /nowhere/a: No such file or directory");
}

TEST(OutputFile, GivesEveryWriteToTheSystemAtOnce) {
  TemporaryFolder folder;
  OutputFile file(folder / "a");
  file.write("one");
  EXPECT_EQ(read_whole_file(folder / "a"), "one");
  file.write("two");
  EXPECT_EQ(read_whole_file(folder / "a"), "onetwo");
}

TEST(WriteAtomically, ReplacesTheContentAndLeavesNoTemporaryFile) {
  TemporaryFolder folder;
  write_atomically(folder / "a", "old and long");
  write_atomically(folder / "a", "new");
  EXPECT_EQ(read_whole_file(folder / "a"), "new");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.new"));
}

// A limit on the file size fails a write as a full disk does, without needing a small disk.
TEST(WriteAtomically, KeepsTheOldContentWhenTheDiskIsFull) {
  TemporaryFolder folder;
  write_atomically(folder / "a", "old");
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{100, before.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string text =
      error_text<RunError>([&] { write_atomically(folder / "a", std::string(1000, 'x')); });
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_THAT(text, HasSubstr("File too large"));
  EXPECT_EQ(read_whole_file(folder / "a"), "old");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.new"));
}

TEST(ReplaceKeeping, KeepsThePreviousContent) {
  TemporaryFolder folder;
  replace_keeping(folder / "a", folder / "b", "first");
  EXPECT_FALSE(std::filesystem::exists(folder / "b"));
  replace_keeping(folder / "a", folder / "b", "second");
  EXPECT_EQ(read_whole_file(folder / "a"), "second");
  EXPECT_EQ(read_whole_file(folder / "b"), "first");
}

TEST(ReadWholeFile, NamesWhatItCannotRead) {
  EXPECT_EQ(error_text<InputError>([] { read_whole_file("/nowhere/a"); }),
            "cannot read /nowhere/a: No such file or directory");
  EXPECT_THAT(error_text<InputError>([] { read_whole_file("/tmp"); }), HasSubstr("is a folder"));
}

TEST(ReadWholeFile, ReadsAnEmptyFile) {
  TemporaryFolder folder;
  write_atomically(folder / "empty", "");
  EXPECT_EQ(read_whole_file(folder / "empty"), "");
}

}  // namespace
}  // namespace retiarius
